"""Where the work on a specimen goes, stage by stage."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from grus.errors import GrusError
from grus.plotting.frame import draw_key, new_figure
from grus.plotting.labels import prefixed
from grus.plotting.style import BLACK, GREEN, GREY, ORANGE, PURPLE, SKY, VERMILION, style

TALL = (5.2, 5.0)
"""Width and height in inches of a figure of two panels, its key not included."""
CLOSED = 1.0
"""Error that counts as closed [%]."""
_COLOURS = (SKY, GREEN, VERMILION, ORANGE, PURPLE)
_MOST_NAMES = 24


@style()
def energy_plot(
    progress: np.ndarray,
    stages: Sequence[str],
    work: np.ndarray,
    parts: Mapping[str, np.ndarray],
    error: np.ndarray,
    title: str | None = None,
    size: tuple[float, float] = TALL,
) -> Figure:
    """Energies stacked on each other under the line of the work; below, what the balance lacks.

    progress (n,): number of the stage plus the share of it that is done, which gives all stages the same width. stages:
    their names, from 0 on. work and parts by name: (n,) [J]. error (n,): of the balance, as a share [-].

    Raises GrusError for no rows, unequal columns, and more than five parts.
    """
    shapes = {np.shape(column) for column in (progress, work, error, *parts.values())}
    if len(shapes) != 1 or len(next(iter(shapes))) != 1 or not np.size(work):
        raise GrusError(f"energies: columns of shapes {sorted(shapes)}; must be of one length")
    if not 0 < len(parts) <= len(_COLOURS):
        raise GrusError(f"parts: {len(parts)}; must be 1 to {len(_COLOURS)}")
    figure, axes = new_figure(size, key_rows=2 + len(parts))
    axes.remove()
    upper, lower = figure.subplots(2, 1, sharex=True, gridspec_kw={"height_ratios": [2.6, 1.0]})
    factor, unit = prefixed(float(np.abs(work).max()), "J")
    areas = upper.stackplot(
        progress, *(factor * part for part in parts.values()), colors=_COLOURS, linewidth=0
    )
    line = upper.plot(progress, factor * work, color=BLACK, linewidth=1.2)[0]
    upper.set_ylabel(f"Energy [{unit}]")
    lower.axhspan(-CLOSED, CLOSED, color=GREEN, alpha=0.12, linewidth=0)
    lower.axhline(0.0, color=GREY, linewidth=0.8)
    lower.plot(progress, 100 * error, color=BLACK, linewidth=1.2)
    reach = max(1.3 * CLOSED, 110 * float(np.abs(error).max()))
    lower.set_ylim(-reach, reach)
    lower.set_ylabel("Error [%]")
    _name_stages(upper, lower, stages)
    note = f"error: work that no energy accounts for, over all energy put in so far; shaded: {CLOSED:g} %"
    handles = [line, *areas, upper.plot([], [], " ")[0]]
    draw_key(figure, handles, ["work of the platens", *parts, note])
    if title is not None:
        upper.set_title(title)
    return figure


def _name_stages(upper: Axes, lower: Axes, stages: Sequence[str]) -> None:
    """Names below the middle of each stage, grid lines between them."""
    lower.set_xlim(0, len(stages))
    every = -(-len(stages) // _MOST_NAMES)
    lower.set_xticks(
        np.arange(0, len(stages), every) + 0.5, stages[::every], rotation=35, ha="right"
    )
    upper.tick_params(labelbottom=False)
    for axes in (upper, lower):
        axes.tick_params(axis="x", length=0)
        axes.grid(False, axis="x")
        for end in range(1, len(stages)):
            axes.axvline(end, color="#BBBBBB", linewidth=0.6, zorder=0.5)
