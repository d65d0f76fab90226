"""Timings in a folder, so that a measurement can go on where it was cut off."""

import hashlib
import json
import re
from collections.abc import Sequence
from pathlib import Path

import grus
from grus.bench.cases import Case
from grus.bench.measure import Timing
from grus.bench.report import summary
from grus.errors import GrusError
from grus.files import write_text
from grus.version import __version__

NAME = "bench.json"


def conditions() -> dict[str, str]:
    """What timings that are compared must share: processor, version, and the compiled engines."""
    processor = re.search(r"model name\s*:\s*(.+)", Path("/proc/cpuinfo").read_text())
    engines = Path(grus.__file__).with_name("_engines.so").read_bytes()
    return {
        "processor": processor[1] if processor else "unknown",
        "grus": __version__,
        "engines": hashlib.sha256(engines).hexdigest(),
    }


def write(folder: str | Path, timings: Sequence[Timing]) -> Path:
    """Writes bench.json into `folder`, which is made when missing; returns its path."""
    path = Path(folder) / NAME
    path.parent.mkdir(parents=True, exist_ok=True)
    found = {"conditions": conditions()} | summary(timings)
    return write_text(path, json.dumps(found, indent=2) + "\n")


def read(folder: str | Path) -> list[Timing]:
    """Timings that `write` has put into `folder`; none when there is no file.

    Raises GrusError when the file is damaged, or was measured under other conditions than there are now.
    """
    path = Path(folder) / NAME
    if not path.exists():
        return []
    try:
        found = json.loads(path.read_text("utf-8"))
        before = found["conditions"] | {}
        timings = [_timing(**entry) for entry in found["timings"]]
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        wanted = "allowed: a file of grus bench; or measure anew with --restart"
        raise GrusError(f"{path} cannot be read ({type(error).__name__}); {wanted}") from error
    for name, now in conditions().items():
        if before.get(name) != now:
            allowed = f"allowed: {now}, as now; or measure anew with --restart"
            raise GrusError(f"{path}: {name} = {before.get(name)}; {allowed}")
    return timings


def _timing(
    case: dict, loop: str, elements: int, bonds: int, step: float, repeats: int, **_: float
) -> Timing:
    return Timing(Case(**case), loop, elements, bonds, step, repeats)
