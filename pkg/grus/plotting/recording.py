"""A recording with its segments: stress and strain in time, and strain against stress."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from grus.errors import GrusError
from grus.plotting.frame import new_figure
from grus.plotting.labels import log_ticks, prefixed
from grus.plotting.style import BLACK, BLUE, GREEN, GREY, ORANGE, SKY, VERMILION, style
from grus.record import KINDS, Kind, Record

WIDE = (8.4, 4.4)
"""Width and height in inches, the key not included."""
COLOURS: dict[Kind, str] = {
    "seat": GREY,
    "load": BLUE,
    "reload": SKY,
    "unload": ORANGE,
    "hold": GREEN,
    "event": VERMILION,
}
NAMES: dict[Kind, str] = {
    "seat": "seating",
    "load": "loading",
    "reload": "reloading",
    "unload": "unloading",
    "hold": "hold",
    "event": "event",
}
_TIMES = ((2 * 86400.0, 86400.0, "d"), (2 * 3600.0, 3600.0, "h"), (120.0, 60.0, "min"))
_MOST_NUMBERS = 24
"""Stages up to this number are numbered in the plot."""
_NARROW = 0.02
"""Share of the width below which the number of a stage has no place."""
_DECADES = 3.0
"""Decades below the highest stress that the stress axis shows."""


@style()
def recording_plot(
    record: Record, title: str | None = None, size: tuple[float, float] = WIDE
) -> Figure:
    """Axial stress and strain against time (or the number of the reading), and strain against stress, by segment.

    Raises GrusError for a record without `axial_stress` or `axial_strain`, and one without readings.
    """
    for name in ("axial_stress", "axial_strain"):
        if name not in record.channels or not len(record):
            raise GrusError(f"record: no readings of {name}; a plot of a recording needs some")
    kinds = [kind for kind in KINDS if any(s.kind == kind for s in record.segments)]
    figure, axes = new_figure(size, key_rows=1)
    axes.remove()
    grid = figure.add_gridspec(2, 2, width_ratios=[1.55, 1.0])
    above = figure.add_subplot(grid[0, 0])
    below = figure.add_subplot(grid[1, 0], sharex=above)
    beside = figure.add_subplot(grid[:, 1])
    place, label = _places(record)
    factor, unit = prefixed(float(np.abs(record["axial_stress"]).max()) or 1.0, "Pa")
    stress, strain = factor * record["axial_stress"], 100 * record["axial_strain"]
    marker = "." if len(record) <= 150 else ""
    for panel, values in ((above, stress), (below, strain)):
        panel.plot(place, values, marker=marker, color=BLACK, lw=0.9, markersize=3.5)
        _draw_bands(panel, record, place)
    _number(above, record, place)
    above.tick_params(labelbottom=False)
    above.set_ylabel(f"Axial stress [{unit}]")
    below.set_ylabel("Axial strain [%]")
    below.set_xlabel(label)
    below.invert_yaxis()
    _draw_curve(beside, record, stress, strain, unit)
    figure.legend(
        [Patch(color=COLOURS[kind], alpha=0.75) for kind in kinds] or [Patch(color=BLACK)],
        [NAMES[kind] for kind in kinds] or ["not cut into segments"],
        loc="lower center",
        ncol=max(len(kinds), 1),
        fontsize=7.5,
    )
    if title is not None:
        figure.suptitle(title, fontsize=10.5)
    return figure


def _places(record: Record) -> tuple[np.ndarray, str]:
    """Place of each reading on the horizontal axis (n,), and what it is."""
    if "time" not in record.channels:
        return np.arange(len(record)), "Reading"
    time = record["time"]
    for least, size, unit in _TIMES:
        if np.ptp(time) >= least:
            return time / size, f"Time [{unit}]"
    return time, "Time [s]"


def _draw_bands(axes: Axes, record: Record, place: np.ndarray) -> None:
    for segment in record.segments:
        start, end = place[segment.first], place[segment.last]
        strong = segment.kind == "event"
        axes.axvspan(start, end, color=COLOURS[segment.kind], alpha=0.6 if strong else 0.22, lw=0)
        if end - start <= 1e-3 * np.ptp(
            place
        ):  # a step at once, or an event: no band could be seen
            axes.axvline(start, color=COLOURS[segment.kind], lw=1.0, alpha=0.8)


def _number(axes: Axes, record: Record, place: np.ndarray) -> None:
    """Numbers of the stages along the upper edge, where there is room."""
    whole = [segment for segment in record.segments if segment.kind != "event"]
    if len(whole) > _MOST_NUMBERS:
        return
    for segment in whole:
        start, end = place[segment.first], place[segment.last]
        if end - start >= _NARROW * np.ptp(place):
            axes.text(
                (start + end) / 2,
                1.01,
                str(segment.stage),
                transform=axes.get_xaxis_transform(),
                ha="center",
                va="bottom",
                fontsize=7,
                color=BLACK,
            )


def _draw_curve(
    axes: Axes, record: Record, stress: np.ndarray, strain: np.ndarray, unit: str
) -> None:
    axes.plot(stress, strain, color=GREY, lw=0.7)
    for segment in record.segments:
        if segment.kind != "event":
            rows = segment.rows
            axes.plot(stress[rows], strain[rows], color=COLOURS[segment.kind], lw=1.8)
    for segment in record.segments:
        if segment.kind == "event":
            axes.plot(stress[segment.rows], strain[segment.rows], "o-", color=VERMILION)
    axes.set_xscale("log")
    high = float(stress.max())
    low = max(float(stress[stress > 0].min(initial=high)), high / 10**_DECADES)
    margin = (high / low) ** 0.04 if high > low else 1.3
    axes.set_xlim(low / margin, high * margin)
    ticks = log_ticks(*axes.get_xlim())
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.set_xticks([], minor=True)
    axes.set_xlabel(f"Axial stress [{unit}]")
    axes.set_ylabel("Axial strain [%]")
    axes.invert_yaxis()
