"""The page: one HTML file that needs no other."""

import base64
import shlex
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from grus.diagnosis.diagnosis import Diagnosis
from grus.diagnosis.report import tables
from grus.diagnosis.report.spoken import chances, quantity
from grus.diagnosis.report.words import answers
from grus.mechanisms import MECHANISMS
from grus.plotting.style import BLUE, GREEN, ORANGE, PURPLE

TEMPLATE = "page.html.j2"
COLOURS = {"nothing": GREEN, "named": BLUE, "cannot_tell": ORANGE, "unknown": PURPLE}


def page(diagnosis: Diagnosis, pictures: Mapping[str, Path], versions: Mapping[str, str]) -> str:
    """HTML. pictures: SVG files by the names of the figures; they are put into the page."""
    environment = Environment(
        loader=FileSystemLoader(Path(__file__).parent), autoescape=True, undefined=StrictUndefined
    )
    inside = {name: _inside(path) for name, path in pictures.items()}
    content = _content(diagnosis)
    return environment.get_template(TEMPLATE).render(**content, pictures=inside, versions=versions)


def _inside(path: Path) -> str:
    return f"data:image/svg+xml;base64,{base64.b64encode(path.read_bytes()).decode()}"


def _content(d: Diagnosis) -> dict[str, Any]:
    suspects = {name for one in d.explanations for name in one.names}
    white = {
        name: chances(getattr(d.whiteness, name)) for name in ("chi_squared", "runs", "neighbours")
    }
    return {
        "name": d.recording_name or "a record",
        "model": d.card.name,
        "told": answers(d),
        "colour": COLOURS[d.verdict],
        "improved": d.improvement is not None,
        "overfit": d.improvement is not None and d.improvement.overfit,
        "errors": None if d.improvement is None else tables.errors(d),
        "sizes": tables.sizes(d),
        "culprits": [MECHANISMS[one.name] for one in d.culprits],
        "explanations": len(d.explanations),
        "suspects": len(suspects),
        "chances": white,
        "calibration": tables.calibration(d),
        "run_count": d.runs,
        "minutes": quantity(d.seconds, "s"),
        "stages": d.protocol.stages,
        "runs": tables.runs(d),
        "command": _command(d),
        "hash": d.recording_hash,
        "card_hash": d.card.content_hash(),
        "seed": d.seed,
        "notes": d.notes,
    }


def _command(d: Diagnosis) -> str:
    recording = d.recording_name or "RECORDING.csv"
    words = ["grus", "diagnose", recording, "--model", Path(d.card.source).name]
    return shlex.join([*words, "--seed", str(d.seed), "--out", "diagnosis"])
