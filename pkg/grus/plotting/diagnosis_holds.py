"""Holds against the logarithm of time, before and after mechanisms were put back."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from grus.diagnosis.report.curves import StageCurve
from grus.plotting.frame import new_figure
from grus.plotting.labels import log_ticks
from grus.plotting.style import BLACK, BLUE, VERMILION, style
from grus.record import Record

COLUMNS, MOST = 4, 8
PANEL = (2.55, 2.3)
"""Width and height of one hold in inches."""
_HOUR = 3600.0


@style()
def holds_plot(record: Record, holds: Sequence[StageCurve]) -> Figure:
    """Strain since the beginning of each hold, at most eight, those with most strain.

    Models as simulated, but foreseen from other stages where a hold was left out of the fit (dashed).
    """
    shown = sorted(sorted(holds, key=_strain, reverse=True)[:MOST], key=lambda one: one.stage)
    columns = min(COLUMNS, len(shown))
    rows = -(-len(shown) // columns)
    figure, axes = new_figure((max(columns, 2) * PANEL[0], rows * PANEL[1]), key_rows=1)
    axes.remove()
    panels = figure.subplots(rows, columns, sharey=True, squeeze=False).ravel()
    for panel, one in zip(panels, shown):
        _draw(panel, record, one)
    for panel in panels[len(shown) :]:
        panel.remove()
    panels[0].invert_yaxis()
    for number in range(0, len(shown), columns):
        panels[number].set_ylabel("Strain since then [%]", fontsize=9)
    for panel in panels[: len(shown)]:
        panel.set_xlabel("Time since its beginning [h]", fontsize=9)
    handles = [Line2D([], [], color=BLACK, marker=".", ls=""), Line2D([], [], color=BLUE)]
    labels = ["recording", "calibrated base"]
    if any(one.after is not None for one in shown):
        handles.append(Line2D([], [], color=VERMILION))
        labels.append("base with what was left out put back (dashed: foreseen)")
    figure.legend(handles, labels, loc="lower center", ncol=3, fontsize=8)
    return figure


def _strain(one: StageCurve) -> float:
    return abs(one.recorded[-1] - one.recorded[0])


def _draw(axes: Axes, record: Record, one: StageCurve) -> None:
    since = (record["time"][one.rows] - one.time[0]) / _HOUR
    late = since > 0
    strain = record["axial_strain"][one.rows] - one.recorded[0]
    axes.plot(since[late], 100 * strain[late], ".", color=BLACK, markersize=3, alpha=0.55)
    knots = (one.time[1:] - one.time[0]) / _HOUR
    models, line = one.foreseen or (one.before, one.after), "--" if one.foreseen else "-"
    for model, colour in zip(models, (BLUE, VERMILION)):
        if model is not None:
            axes.plot(knots, 100 * (model[1:] - model[0]), line, marker="o", ms=3, color=colour)
    axes.set_xscale("log")
    low = min(since[late].min(initial=knots[0]), knots[0])
    axes.set_xlim(low / 1.3, knots[-1] * 1.3)
    ticks = log_ticks(*axes.get_xlim())
    ticks = ticks[:: 1 + (len(ticks) - 1) // 5]
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks], fontsize=8)
    axes.set_xticks([], minor=True)
    axes.set_title(f"Stage {one.stage}, {one.stress[-1] / 1e3:.3g} kPa", fontsize=9)
