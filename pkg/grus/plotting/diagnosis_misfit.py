"""Map of the misfit over stages and their course, with the share of each stage."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import BoundaryNorm
from matplotlib.cm import ScalarMappable
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from grus.diagnosis.report.differences import Row
from grus.plotting.frame import new_figure
from grus.plotting.style import BLACK, VERMILION, style

WIDTH = 10.0
ROW = 0.36
"""Height of a stage in inches."""
LIGHT = "#CCCCCC"
"""Shares of what chance may give."""
_BOUNDS = (-10, -5, -3, -2, -1, 1, 2, 3, 5, 10)
_COLOURS = "RdBu_r"


@style()
def misfit_plot(stages: Sequence[Row]) -> Figure:
    """A row a stage from its beginning to its end, a field a cell, its colour the difference in standard deviations;
    beside it the share of the misfit, grey where chance may give as much. In each field stands where it ends.
    """
    figure, axes = new_figure((WIDTH, 1.0 + ROW * len(stages)))
    axes.remove()
    chart, bars = figure.subplots(1, 2, width_ratios=[3.6, 1.0])
    norm = BoundaryNorm(_BOUNDS, 256, extend="both")
    colours = ScalarMappable(norm, _COLOURS)
    for row, one in enumerate(stages):
        _draw(chart, row, one, colours)
    names = [one.name for one in stages]
    chart.set_xlim(0, 1)
    chart.set_xticks([0, 1], ["beginning", "end of the stage"])
    for label, side in zip(chart.get_xticklabels(), ("left", "right")):
        label.set_horizontalalignment(side)
    chart.grid(False)
    shares = [100 * one.share for one in stages]
    colour = [VERMILION if one.clear else LIGHT for one in stages]
    bars.barh(range(len(stages)), shares, color=colour, height=0.62)
    for row, share in enumerate(shares):
        bars.text(share + 2, row, f"{share:.0f} %", va="center", fontsize=8)
    bars.set_xlim(0, 125)
    bars.set_xticks([0, 50, 100])
    bars.set_xlabel("Share of the misfit [%]")
    for panel, labels in ((chart, names), (bars, [""] * len(names))):
        panel.set_ylim(len(stages) - 0.5, -0.5)
        panel.set_yticks(range(len(stages)), labels)
        panel.tick_params(axis="y", length=0)
    bar = figure.colorbar(colours, ax=chart, orientation="horizontal", aspect=50, pad=0.02)
    bar.set_label("Recording less calibrated base, in standard deviations of noise and scatter")
    bar.set_ticks(_BOUNDS, labels=[f"{b:+d}" for b in _BOUNDS])
    return figure


def _draw(axes: Axes, row: int, one: Row, colours: ScalarMappable) -> None:
    edges = np.linspace(0, 1, len(one.fields) + 1)
    for left, right, end, value in zip(edges, edges[1:], one.fields, one.deviations):
        colour = colours.to_rgba(value)
        axes.add_patch(
            Rectangle((left, row - 0.44), right - left, 0.88, facecolor=colour, edgecolor="white")
        )
        dark = np.dot(colour[:3], (0.299, 0.587, 0.114)) < 0.5
        axes.text(
            right - 0.006,
            row,
            end,
            ha="right",
            va="center",
            fontsize=7.5,
            color="white" if dark else BLACK,
        )
