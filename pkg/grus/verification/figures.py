"""Figures of the verification."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from grus.plotting.style import BLACK, BLUE, GREY, ORANGE, SKY, VERMILION, style
from grus.verification.other_laws_block import Curves
from grus.verification.row import Row

LOOKS = (  # lines that lie on one another are told apart by width
    {"color": SKY, "lw": 4.5},
    {"color": BLACK, "lw": 1.4},
    {"color": VERMILION, "lw": 1.4, "ls": (0, (4, 2))},
)
LEAST = 1e-17  # where a deviation of 0 is drawn


@style()
def block_figure(curves: Curves) -> Figure:
    """Force and broken bonds of the blocks against displacement, one column a loading, one line a law."""
    figure = Figure(figsize=(9.6, 5.2), layout="constrained")
    axes = figure.subplots(2, len(curves), sharex="col", squeeze=False)
    for column, (loading, by_law) in zip(axes.T, curves.items()):
        force, bonds = column
        for look, (law, curve) in zip(LOOKS, by_law.items()):
            micrometres = 1e6 * curve.displacement
            force.plot(micrometres, curve.force, label=law, **look)
            bonds.plot(micrometres, curve.bonds[0] - curve.bonds, **look)
        force.set_title(f"{loading}, {curve.spheres} spheres")
        bonds.set_xlabel("Displacement [µm]")
    axes[0, 0].set_ylabel("Force [N]")
    axes[1, 0].set_ylabel("Broken bonds [1]")
    axes[0, 0].legend(loc="upper left")
    return figure


@style()
def deviation_figure(rows: Sequence[Row]) -> Figure:
    """Deviation and tolerance of every counted row, in the order of the table."""
    counted = [row for row in rows if row.tolerance is not None]
    number = np.arange(1, len(counted) + 1)
    deviation = np.array([np.nan_to_num(row.deviation, nan=np.inf) for row in counted])
    tolerance = np.array([row.tolerance for row in counted])
    passed = np.array([row.passed for row in counted])
    shown = np.clip(deviation, LEAST, 10.0)
    figure = Figure(figsize=(9.6, 4.0), layout="constrained")
    axes = figure.subplots()
    axes.plot(
        number,
        np.maximum(tolerance, LEAST),
        "_",
        color=ORANGE,
        markersize=6,
        mew=1.6,
        label="tolerance",
    )
    axes.plot(number[passed], shown[passed], "o", color=BLUE, label="deviation")
    if not passed.all():
        axes.plot(
            number[~passed], shown[~passed], "X", color=VERMILION, ms=8, label="out of tolerance"
        )
    axes.set_yscale("log")
    axes.set_ylim(LEAST / 3, 30.0)
    axes.set_xlim(0, len(counted) + 6)  # room for the name of a short last part
    _mark_parts(axes, [row.part for row in counted])
    axes.set_xlabel("Row of the table, without those that only inform")
    axes.set_ylabel("Deviation, relative to the expectation [1]")
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncol=3)
    return figure


def _mark_parts(axes: Axes, parts: list[str]) -> None:
    """A line before each part of the table, its name above."""
    starts = [i for i, part in enumerate(parts) if i == 0 or part != parts[i - 1]]
    for start in starts:
        if start:
            axes.axvline(start + 0.5, color=GREY, lw=0.8)
        axes.text(start + 1, 6.0, parts[start], ha="left", va="center", fontsize=8.5)
