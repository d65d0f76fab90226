"""Recording, calibrated base and base with mechanisms: strain against stress and against time."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from grus.diagnosis.report.curves import StageCurve
from grus.plotting.frame import new_figure
from grus.plotting.labels import log_ticks, prefixed
from grus.plotting.style import BLACK, BLUE, GREY, ORANGE, VERMILION, style
from grus.record import Record

WIDE = (10.0, 4.6)
"""Width and height in inches, the key not included."""
LEFT_OUT = ORANGE
_DAY = 86400.0
_ROOM = 0.6
"""Strain beyond that of recording and models that is shown, as a share of theirs: specimens that collapse go further."""


@style()
def curves_plot(
    record: Record, stages: Sequence[StageCurve], size: tuple[float, float] = WIDE
) -> Figure:
    """Axial strain against axial stress (logarithmic) and against time or the number of the reading: the models as simulated, and
    what they foresee of the stages left out of the fit (shaded) from the recorded beginning of each (dashed).
    """
    figure, axes = new_figure(size, key_rows=2)
    axes.remove()
    beside, along = figure.subplots(1, 2, sharey=True, width_ratios=[1.0, 1.35])
    clock, label = np.arange(float(len(record))), "Reading"
    scale = 1.0
    if "time" in record.channels:
        size, unit = (_DAY, "d") if np.ptp(record["time"]) > 4 * _DAY else (_DAY / 24, "h")
        clock, label, scale = record["time"] / size, f"Time [{unit}]", 1 / size
    factor, unit = prefixed(float(record["axial_stress"].max()), "Pa")
    rows = np.unique(np.concatenate([one.rows for one in stages]))
    strain = 100 * record["axial_strain"]
    for panel, x in ((beside, factor * record["axial_stress"]), (along, clock)):
        panel.plot(x[rows], strain[rows], ".", color=BLACK, markersize=3, alpha=0.55, zorder=2)
    for one in stages:
        _draw(beside, one, factor * one.stress)
        _draw(along, one, scale * one.time)
        if one.foreseen:
            along.axvspan(
                scale * one.time[0], scale * one.time[-1], color=LEFT_OUT, alpha=0.13, lw=0
            )
    _log_stress(beside, factor * np.concatenate([one.stress for one in stages]), unit)
    along.set_xlabel(label)
    beside.set_ylabel("Axial strain [%]")
    _limit(beside, strain[rows], stages)
    _key(figure, stages)
    return figure


def _draw(axes: Axes, one: StageCurve, x: np.ndarray) -> None:
    for specimen in one.specimens:
        axes.plot(x, 100 * specimen, color=GREY, lw=0.6, alpha=0.5, zorder=1)
    for model, colour in ((one.before, BLUE), (one.after, VERMILION)):
        if model is not None:
            axes.plot(x, 100 * model, color=colour, lw=1.7, zorder=3)
    for model, colour in zip(one.foreseen or (), (BLUE, VERMILION)):
        axes.plot(x, 100 * model, "--", color=colour, lw=1.7, zorder=4)


def _log_stress(axes: Axes, stress: np.ndarray, unit: str) -> None:
    low, high = stress[stress > 0].min(), stress.max()
    margin = (high / low) ** 0.04
    axes.set_xscale("log")
    axes.set_xlim(low / margin, high * margin)
    ticks = log_ticks(*axes.get_xlim())
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.set_xticks([], minor=True)
    axes.set_xlabel(f"Axial stress [{unit}]")


def _limit(axes: Axes, strain: np.ndarray, stages: Sequence[StageCurve]) -> None:
    models = [one.before for one in stages] + [o.after for o in stages if o.after is not None]
    models += [model for one in stages for model in one.foreseen or ()]
    shown = np.concatenate([strain, 100 * np.concatenate(models)])
    wide = np.ptp(shown)
    specimens = 100 * np.concatenate([one.specimens.ravel() for one in stages])
    low = max(min(specimens.min(initial=np.inf), shown.min()), shown.min() - _ROOM * wide)
    high = min(max(specimens.max(initial=-np.inf), shown.max()), shown.max() + _ROOM * wide)
    axes.set_ylim(high + 0.04 * wide, low - 0.04 * wide)


def _key(figure: Figure, stages: Sequence[StageCurve]) -> None:
    with_fit = any(one.after is not None for one in stages)
    handles = [
        Line2D([], [], color=BLACK, marker=".", ls=""),
        Line2D([], [], color=BLUE),
        Line2D([], [], color=GREY, lw=0.8),
    ]
    labels = ["recording", "calibrated base, as simulated", "its specimens"]
    if with_fit:
        handles[2:2] = [Line2D([], [], color=VERMILION)]
        labels[2:2] = ["base with what was left out put back"]
    if any(one.foreseen for one in stages):
        handles += [Patch(color=LEFT_OUT, alpha=0.2), Line2D([], [], color=GREY, ls="--")]
        labels += ["stages left out of the fit", "foreseen there from the other stages"]
    figure.legend(handles, labels, loc="lower center", ncol=3, fontsize=8)
