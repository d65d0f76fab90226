"""Lateral stress at rest."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from grus.compression import first_loading
from grus.errors import GrusError
from grus.plotting.frame import SINGLE, draw_key, new_figure
from grus.plotting.labels import log_ticks
from grus.plotting.style import BLUE, VERMILION, style


@style()
def lateral_plot(
    stress: np.ndarray,
    ratio: np.ndarray,
    apart: np.ndarray,
    ends: np.ndarray,
    title: str | None = None,
    size: tuple[float, float] = SINGLE,
) -> Figure:
    """K0 against the axial stress: first loading strong, readings `apart` thin, ends of stages marked.

    stress [Pa], ratio [-]: (n,) in the order of the test. apart (n,): mask of the readings of unloading and the like.
    ends: rows at which stages ended. Drops of the stress while grains break are left out.

    Raises GrusError for unequal columns and when no stress is above zero.
    """
    stress, ratio = np.asarray(stress, dtype=float), np.asarray(ratio, dtype=float)
    if stress.ndim != 1 or stress.shape != ratio.shape:
        raise GrusError(
            f"K0: columns of shapes {stress.shape} and {ratio.shape}; must be of one length"
        )
    if not (stress > 0).any():
        raise GrusError("K0: no stress above zero; must have one at least")
    figure, axes = new_figure(size, key_rows=3)
    first = first_loading(stress)
    thin = np.where(apart & (stress > 0), 1e-3 * stress, np.nan)
    stress = 1e-3 * stress
    lines = axes.plot(stress[first], ratio[first], color=BLUE, zorder=3)
    lines += axes.plot(thin, ratio, color=BLUE, linewidth=0.8, alpha=0.7)
    lines += axes.plot(
        stress[ends],
        ratio[ends],
        "o",
        color=VERMILION,
        markeredgecolor="white",
        markersize=5.5,
        zorder=4,
    )
    labels = ["first loading", "unloading, reloading, holds", "at rest, end of a stage"]
    axes.set_ylim(bottom=0)
    low, high = np.nanmin([stress[first].min(), *thin[apart]]), stress.max()
    axes.set_xscale("log")
    axes.set_xlim(low * (low / high) ** 0.03, high * (high / low) ** 0.03)
    ticks = log_ticks(*axes.get_xlim())
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.set_xticks([], minor=True)
    axes.set_xlabel(r"Axial stress $\sigma$ [kPa]")
    axes.set_ylabel(r"$K_0$ = side over axial stress [–]")
    draw_key(figure, lines, labels)
    if title is not None:
        axes.set_title(title)
    return figure
