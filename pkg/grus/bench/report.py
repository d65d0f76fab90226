"""Timings as a table and as figures for JSON."""

import math
from collections.abc import Sequence
from dataclasses import asdict

from rich.console import Console
from rich.table import Table

from grus.bench.cases import LOOPS, OTHER_CODES, Case
from grus.bench.measure import Timing


def summary(timings: Sequence[Timing]) -> dict:
    """Everything measured, and `ratio`: duration of a step of each loop over that of GrainLoop.

    The ratio is the geometric mean over the loop's cases with one thread and the most elements, stamped ones where
    there are. `not_installed` names the loops that a case could not be measured with.
    """
    names = [loop for loop in LOOPS | OTHER_CODES if loop != "grainloop"]
    ratios = {f"{loop}_over_grainloop": _ratio(timings, loop) for loop in names}
    absent = {case.name: _absent(timings, case) for case in _cases(timings)}
    return {
        "ratio": {name: ratio for name, ratio in ratios.items() if ratio},
        "not_installed": {case: found for case, found in absent.items() if found},
        "timings": [
            asdict(t) | {"seconds_per_bond": t.per_bond, "element_steps_per_second": t.rate}
            for t in timings
        ],
    }


def print_table(timings: Sequence[Timing], console: Console) -> None:
    """A table a case, one line a loop; fits into 80 columns."""
    found = {(t.case, t.loop): t for t in timings}
    for case in _cases(timings):
        size = next(t for t in timings if t.case == case)
        table = Table(
            title=f"{case.name}: {size.elements} elements, {size.bonds} bonds",
            title_justify="left",
        )
        table.add_column("loop", width=28)
        for heading in ("ms/step", "ns/bond", "10⁶ element-\nsteps/s", "over\nGrainLoop"):
            table.add_column(heading, justify="right")
        grus = found.get((case, "grainloop"))
        for loop, title in case.loops.items():
            if t := found.get((case, loop)):
                table.add_row(title, *_figures(t, grus))
            else:
                table.add_row(f"{title}\n(not installed)")
        console.print(table)


def _figures(t: Timing, grus: Timing | None) -> list[str]:
    figures = [1e3 * t.step, 1e9 * t.per_bond, 1e-6 * t.rate]
    figures += [t.step / grus.step] if grus else []
    return [f"{value:.0f}" if value >= 100 else f"{value:.3g}" for value in figures]


def _ratio(timings: Sequence[Timing], loop: str) -> float | None:
    """None where the loop was not measured on one thread beside GrainLoop."""
    steps = _steps(timings)
    both = [
        case
        for case in _cases(timings)
        if case.threads == 1 and (case, loop) in steps and (case, "grainloop") in steps
    ]
    if not both:
        return None
    both = [case for case in both if case.stamped] or both
    largest = max(case.elements for case in both)
    logs = [
        math.log(steps[case, loop] / steps[case, "grainloop"])
        for case in both
        if case.elements == largest
    ]
    return math.exp(sum(logs) / len(logs))


def _cases(timings: Sequence[Timing]) -> list[Case]:
    return list(dict.fromkeys(t.case for t in timings))


def _steps(timings: Sequence[Timing]) -> dict[tuple[Case, str], float]:
    return {(t.case, t.loop): t.step for t in timings}


def _absent(timings: Sequence[Timing], case: Case) -> list[str]:
    steps = _steps(timings)
    return [loop for loop in OTHER_CODES if loop in case.loops and (case, loop) not in steps]
