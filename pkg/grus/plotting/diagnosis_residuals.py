"""What the best explanation leaves, in the order of the test."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from grus.plotting.frame import new_figure
from grus.plotting.style import BLUE, GREY, style

WIDE = (10.0, 2.7)


@style()
def residuals_plot(
    residuals: np.ndarray, groups: Sequence[str], size: tuple[float, float] = WIDE
) -> Figure:
    """Whitened residuals (n,), of unit variance where nothing is left; groups (n,): what each belongs to,
    the number of its stage or a channel."""
    figure, axes = new_figure(size)
    places = np.arange(len(residuals))
    axes.axhspan(-2, 2, color=GREY, alpha=0.15, lw=0)
    axes.vlines(places, 0, residuals, color=BLUE, lw=1.4)
    axes.plot(places, residuals, "o", color=BLUE, ms=3.5)
    axes.axhline(0, color=GREY, lw=0.8)
    firsts = [k for k in places if k == 0 or groups[k] != groups[k - 1]]
    for first in firsts[1:]:
        axes.axvline(first - 0.5, color=GREY, lw=0.6, ls=":")
    axes.set_xticks(firsts, [groups[k] for k in firsts], ha="left", fontsize=8)
    axes.grid(False)
    axes.set_xlim(-0.7, len(residuals) - 0.3)
    reach = max(3.0, 1.1 * float(np.abs(residuals).max(initial=0)))
    axes.set_ylim(-reach, reach)
    axes.set_xlabel("Stage or channel, in the order of the test")
    axes.set_ylabel("Residual [std. dev.]")
    return figure
