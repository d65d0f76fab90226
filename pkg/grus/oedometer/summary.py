"""One screen about an oedometer test."""

from grus.oedometer.analysis import Analysis
from grus.oedometer.evenly import evenly
from grus.oedometer.result import OedometerResult, StageEnd

ROWS = 12
"""Stages in the table at most."""
HEADER = ("", "stress", "strain", "e/e0", "K0", "broken", "fragments", "steps")
WIDTHS = (18, 11, 9, 8, 6, 8, 11, 9)


def summary(result: OedometerResult, analysis: Analysis | None = None) -> str:
    """What went in, the stages in a table, and what came out, in plain lines."""
    found = analysis or Analysis.of(result)
    return "\n".join(
        [*_lines(_head(result)), "", *_table(result, found), "", *_lines(_foot(result, found))]
    )


def _lines(rows: list[tuple[str, str]]) -> list[str]:
    return [f"{name:<14}{text}" for name, text in rows]


def _head(result: OedometerResult) -> list[tuple[str, str]]:
    card, specimen = result.card, result.prepared.specimen
    first, last = result.seated.void_ratio, result.stages[-1].void_ratio
    return [
        ("model", f"{card.name}, {card.dimension}D, seed {card.seed}"),
        (
            "specimen",
            f"{specimen.grain_count} grains, {specimen.element_count} elements in "
            f"{specimen.clump_count} clumps, {result.bonds} bonds",
        ),
        ("void ratio", f"{first:.4f} at the start, {last:.4f} at the end"),
    ]


def _table(result: OedometerResult, found: Analysis) -> list[str]:
    rows = [_row(HEADER)]
    for number in evenly(len(result.stages), ROWS):
        rows.append(_stage(result, result.stages[number], found.fragments[number].count))
    return rows


def _stage(result: OedometerResult, end: StageEnd, fragments: int) -> str:
    seated = result.seated
    return _row(
        (
            end.name,
            f"{end.axial_stress / 1e3:.1f} kPa",
            f"{100 * (1 - end.height / seated.height):.3f} %",
            f"{end.void_ratio / seated.void_ratio:.4f}",
            f"{end.K0:.2f}",
            f"{end.breaks}",
            f"{fragments}",
            f"{end.steps}",
        )
    )


def _row(cells: tuple[str, ...]) -> str:
    name, *numbers = cells
    first, *others = WIDTHS
    return name.ljust(first) + "".join(cell.rjust(width) for cell, width in zip(numbers, others))


def _foot(result: OedometerResult, found: Analysis) -> list[tuple[str, str]]:
    last = result.stages[-1]
    share = f", {last.breaks / result.bonds:.2%} of all" if result.bonds else ""
    return [
        ("yield", _yielding(found)),
        ("breakage", _onset(found)),
        ("bonds broken", f"{last.tension_breaks} in tension, {last.shear_breaks} in shear{share}"),
        ("indices", _indices(found)),
        (
            "energy",
            f"balance closes to {abs(result.energy_error[found.rows]).max():.2%} at the end of a stage, at worst",
        ),
        ("mass", f"of all fragments kept to {found.lost_mass():.1g}"),
    ]


def _yielding(found: Analysis) -> str:
    return f"none; {found.yielding}" if isinstance(found.yielding, str) else _stress(found.yielding)


def _onset(found: Analysis) -> str:
    onset = found.onset
    if isinstance(onset, str):
        return f"no onset; {onset}"
    if onset.first_break is None:
        return "none"
    first = f"first at {onset.first_break / 1e3:.3g} kPa, "
    return first + (
        f"sustained from {_stress(onset)} on"
        if onset.stress
        else "not sustained from any stress on"
    )


def _stress(found) -> str:
    low, high = found.interval
    return f"{found.stress / 1e3:.3g} kPa ({found.confidence:.0%} interval {low / 1e3:.3g} to {high / 1e3:.3g})"


def _indices(found: Analysis) -> str:
    last = found.breakage[-1]
    if isinstance(last, str):
        return f"none; {last}"
    return (
        f"Hardin {last.hardin:.3g}, Einav {last.einav:.3g}, Marsal {last.marsal:.3g} %, "
        f"Lee & Farhoomand {last.lee_farhoomand:.3g}"
    )
