"""Crushing strength against grain diameter."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from grus.plotting.frame import SINGLE, draw_key, new_figure
from grus.plotting.labels import MEGA, MILLI, interval, log_ticks, probability, significant
from grus.plotting.style import BLUE, GREEN, GREY, VERMILION, style
from grus.statistics import SizeEffect


@style()
def size_effect_plot(
    effect: SizeEffect, title: str | None = None, size: tuple[float, float] = SINGLE
) -> Figure:
    """Strengths, characteristic strength of each size, fitted slope and expected slope, log-log.

    Strengths of the fits in Pa, diameters in m; drawn in MPa and mm. The shaded wedge is the
    confidence interval of the expected slope, about the centre of the data.
    """
    figure, axes = new_figure(size, key_rows=5)
    strengths = MEGA * np.concatenate([fit.strengths for fit in effect.fits])
    diameters = MILLI * np.array(effect.diameters)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(*_widened(diameters, 0.12))
    axes.set_ylim(*_widened(strengths, 0.05))
    _draw_strengths(axes, effect)
    _draw_slopes(axes, effect)
    for axis, limits in ((axes.xaxis, axes.get_xlim()), (axes.yaxis, axes.get_ylim())):
        ticks = log_ticks(*limits)
        axis.set_ticks(ticks, [f"{tick:g}" for tick in ticks])
        axis.set_ticks([], minor=True)
    axes.set_xlabel("Grain diameter $d$ [mm]")
    axes.set_ylabel(r"Crushing strength $\sigma$ [MPa]")
    handles, labels = axes.get_legend_handles_labels()
    handles.append(axes.plot([], [], " ")[0])
    labels.append(
        f"slope as expected: {probability(effect.agreement_p_value)};"
        f"  one $m$ and a power law: {probability(effect.model_p_value)}"
    )
    draw_key(figure, handles, labels)
    if title is not None:
        axes.set_title(title)
    return figure


def _draw_strengths(axes: Axes, effect: SizeEffect) -> None:
    """Each grain, and the characteristic strength of each size with its interval."""
    sizes = np.repeat(effect.diameters, [fit.n for fit in effect.fits])
    strengths = np.concatenate([fit.strengths for fit in effect.fits])
    axes.plot(
        MILLI * sizes,
        MEGA * strengths,
        "o",
        color=GREY,
        markersize=3,
        markeredgewidth=0,
        alpha=0.45,
        label=f"grains ($n$ = {effect.n})",
    )
    centres = np.array([fit.sigma0 for fit in effect.fits])
    low, high = np.array([fit.sigma0_ci for fit in effect.fits]).T
    axes.errorbar(
        MILLI * np.array(effect.diameters),
        MEGA * centres,
        yerr=MEGA * np.array([centres - low, high - centres]),
        fmt="s",
        color=BLUE,
        markersize=5,
        capsize=3,
        elinewidth=1.2,
        linewidth=1.2,
        zorder=4,
        label=rf"$\sigma_0$ of each size, {100 * effect.confidence:g} %",
    )


def _draw_slopes(axes: Axes, effect: SizeEffect) -> None:
    """Fitted and expected line over the width of the axes; both pass the centre of the data."""
    ends = np.array(axes.get_xlim()) / MILLI
    span = np.geomspace(*ends, 61)
    ratio = span / effect.reference_diameter
    level = f"{100 * effect.confidence:g} %: "
    axes.plot(
        MILLI * span,
        MEGA * effect.strength(span),
        color=VERMILION,
        label=f"fitted slope {significant(effect.slope)} ({level}{interval(*effect.slope_ci)})",
    )
    centre = MEGA * effect.reference_strength
    axes.plot(
        MILLI * span,
        centre * ratio**effect.expected_slope,
        "--",
        color=GREEN,
        label=f"expected slope $-${effect.dimension}/$m$ = {significant(effect.expected_slope)}"
        f" ({level}{interval(*effect.expected_slope_ci)}), $m$ = {significant(effect.modulus)}",
    )
    edges = [centre * ratio**slope for slope in effect.expected_slope_ci]
    axes.fill_between(MILLI * span, *edges, color=GREEN, alpha=0.18, linewidth=0)


def _widened(values: np.ndarray, share: float) -> tuple[float, float]:
    """Limits of positive values, moved apart by this share of their logarithmic distance."""
    factor = (values.max() / values.min()) ** share
    return float(values.min() / factor), float(values.max() * factor)
