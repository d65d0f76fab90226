"""Timings as a table and as JSON."""

import json
import math
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path

from rich.console import Console
from rich.table import Table

from grus.bench.cases import LOOPS
from grus.bench.measure import Timing
from grus.files import write_text


def summary(timings: Sequence[Timing]) -> dict:
    """Everything measured, and `ratio`: duration of a step of each loop over that of GrainLoop.

    The ratio is the geometric mean over the cases with one thread and the most elements, stamped ones where there are.
    """
    single = [t for t in timings if t.case.threads == 1]
    chosen = [t for t in single if t.case.stamped] or single
    largest = max(t.case.elements for t in chosen)
    ratios = {}
    for loop in LOOPS:
        logs = [
            math.log(t.step / fastest.step)
            for t in chosen
            for fastest in chosen
            if t.loop == loop and fastest.loop == "grainloop" and t.case == fastest.case
            if t.case.elements == largest
        ]
        if loop != "grainloop" and logs:
            ratios[f"{loop}_over_grainloop"] = math.exp(sum(logs) / len(logs))
    return {
        "ratio": ratios,
        "timings": [
            asdict(t) | {"case": asdict(t.case), "seconds_per_bond": t.per_bond} for t in timings
        ],
    }


def write(folder: str | Path, timings: Sequence[Timing]) -> Path:
    """Writes bench.json into `folder`; returns its path."""
    path = Path(folder) / "bench.json"
    path.parent.mkdir(parents=True, exist_ok=True)
    return write_text(path, json.dumps(summary(timings), indent=2) + "\n")


def print_table(timings: Sequence[Timing], console: Console) -> None:
    """One line a case and loop."""
    table = Table("case", "loop", "elements", "bonds", "ms a step", "ns a bond", "over GrainLoop")
    fastest = {t.case: t.step for t in timings if t.loop == "grainloop"}
    for t in timings:
        table.add_row(
            t.case.name,
            LOOPS[t.loop],
            str(t.elements),
            str(t.bonds),
            f"{1e3 * t.step:.3g}",
            f"{1e9 * t.per_bond:.3g}",
            f"{t.step / fastest[t.case]:.3g}",
        )
    console.print(table)
