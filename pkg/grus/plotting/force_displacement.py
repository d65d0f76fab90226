"""Force against displacement of the grains of a group."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from grus.errors import GrusError
from grus.plotting.frame import SINGLE, new_figure
from grus.plotting.labels import prefixed, significant
from grus.plotting.style import BLUE, GREY, VERMILION, style


@style()
def force_displacement_plot(
    curves: Sequence[tuple[Sequence[float], Sequence[float]]],
    peaks: Sequence[tuple[float, float]] | None = None,
    highlight: int = 0,
    title: str | None = None,
    size: tuple[float, float] = SINGLE,
) -> Figure:
    """All curves faint, one of them strong, the peak of each marked.

    curves: per grain (displacement [m] (n,), force [N] (n,)). peaks: per grain (displacement [m],
    force [N]), the largest force of each curve when None. highlight: index of the strong curve.

    Raises GrusError for no curves, a curve of unequal or no columns, an index out of range, and
    another number of peaks than curves.
    """
    paths = [_checked_curve(index, curve) for index, curve in enumerate(curves)]
    if not paths:
        raise GrusError("curves: none given; a force-displacement plot needs at least one")
    if not 0 <= highlight < len(paths):
        raise GrusError(f"highlight: {highlight}; must lie in 0..{len(paths) - 1}")
    if peaks is None:
        peaks = [path[:, path[1].argmax()] for path in paths]
    tops = np.array(peaks, dtype=float)
    if tops.shape != (len(paths), 2):
        raise GrusError(f"peaks: shape {tops.shape}; must be (displacement, force) for each curve")
    length, length_unit = prefixed(max(path[0].max() for path in paths), "m")
    force, force_unit = prefixed(max(path[1].max() for path in paths), "N")
    figure, axes = new_figure(size)
    others = [index for index in range(len(paths)) if index != highlight]
    for index in others:
        axes.plot(length * paths[index][0], force * paths[index][1], color=GREY, lw=0.7, alpha=0.45)
    if others:
        axes.plot([], [], color=GREY, lw=0.7, label=f"other grains ({len(others)})")
        axes.plot(
            length * tops[others, 0],
            force * tops[others, 1],
            "o",
            color=BLUE,
            markersize=3.5,
            markerfacecolor="white",
            label="their peaks",
        )
    strong = paths[highlight]
    at, top = tops[highlight]
    axes.plot(length * strong[0], force * strong[1], color=VERMILION, label=f"grain {highlight}")
    axes.plot(
        length * at,
        force * top,
        "D",
        color=VERMILION,
        markeredgecolor="black",
        label=f"its peak: {significant(force * top)} {force_unit}"
        f" at {significant(length * at)} {length_unit}",
    )
    axes.set_xlabel(f"Platen displacement [{length_unit}]")
    axes.set_ylabel(f"Platen force [{force_unit}]")
    axes.set_xlim(left=0.0)
    axes.set_ylim(0.0, 1.3 * force * max(path[1].max() for path in paths))  # room for the legend
    axes.legend(loc="upper left", ncol=2)
    if title is not None:
        axes.set_title(title)
    return figure


def _checked_curve(index: int, curve: tuple[Sequence[float], Sequence[float]]) -> np.ndarray:
    columns = [np.asarray(column, dtype=float) for column in curve]
    if len(columns) != 2 or columns[0].shape != columns[1].shape or columns[0].ndim != 1:
        raise GrusError(
            f"curves: curve {index} has columns of shapes {[c.shape for c in columns]}; "
            "must be displacement and force of one length"
        )
    if not columns[0].size:
        raise GrusError(f"curves: curve {index} is empty; must have at least one reading")
    return np.stack(columns)
