"""Files that tell the outcome of a diagnosis."""

import json
from pathlib import Path
from typing import Any

from grus.campaign.versions import versions
from grus.diagnosis.diagnosis import Diagnosis
from grus.diagnosis.report.figures import figures
from grus.diagnosis.report.page import page
from grus.files import write_text
from grus.plotting import save


def write_report(diagnosis: Diagnosis, folder: str | Path) -> dict[str, Any]:
    """Writes figures (PNG and SVG), report.html and verdict.json into `folder`; returns what verdict.json holds."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    plots = figures(diagnosis)
    pictures = {name: save(figure, folder / name)[1] for name, figure in plots.items()}
    made_with = versions()
    write_text(folder / "report.html", page(diagnosis, pictures, made_with))
    found = diagnosis.to_dict() | {"versions": made_with}
    found["files"] = ["verdict.json", "report.html", *(f"{name}.png" for name in plots)]
    # Last, so that a verdict.json stands for a complete folder.
    write_text(folder / "verdict.json", json.dumps(found, indent=1, allow_nan=False) + "\n")
    return found
