"""Survival of the grains of a group in linearised Weibull coordinates."""

from __future__ import annotations

import itertools
from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from grus.errors import GrusError
from grus.plotting.frame import SINGLE, draw_key, new_figure
from grus.plotting.labels import MEGA, interval, log_ticks, probability, significant, survival_ticks
from grus.plotting.style import BOX, GREY, PALETTE, style
from grus.statistics import SurvivalPoints, WeibullFit, survival_points

_BAND_POINTS = 61


@style()
def weibull_plot(
    fits: WeibullFit | Mapping[str, WeibullFit],
    title: str | None = None,
    size: tuple[float, float] = SINGLE,
) -> Figure:
    """Mean-rank points, fitted line and pointwise confidence band of one group, or several by name.

    Strengths of the fits in Pa. Left and lower axes: survival [%] and strength [MPa]; right and
    upper axes: the same in the coordinates in which the law is a straight line of slope m.

    Raises GrusError when there is no fit, or when the fits differ in their confidence.
    """
    groups = {"": fits} if isinstance(fits, WeibullFit) else dict(fits)
    if not groups:
        raise GrusError("fits: none given; a Weibull plot needs at least one")
    levels = {100.0 * fit.confidence for fit in groups.values()}
    if len(levels) > 1:
        raise GrusError(f"fits: confidences {sorted(levels)} %; must be the same for all")
    level = f"{levels.pop():g} %"
    single = isinstance(fits, WeibullFit)
    figure, axes = new_figure(size, key_rows=0 if single else 1 + len(groups))
    points = [survival_points(fit.strengths, fit.censored) for fit in groups.values()]
    bottom, top = _widened(np.concatenate([group.ordinate for group in points]), 0.08)
    colours = itertools.cycle(PALETTE)
    ends = [
        _draw_group(axes, fit, group, next(colours), bottom, top)
        for fit, group in zip(groups.values(), points)
    ]
    abscissas = [group.abscissa + np.log(MEGA) for group in points]
    axes.set_xlim(*_widened(np.concatenate(ends + abscissas), 0.04))
    axes.set_ylim(bottom, top)
    _label_axes(axes)
    if single:
        _mark_characteristic_strength(axes, fits)
        _mark_unbroken(axes, fits)
        lines = _estimates(fits, f"{level}: ")
        if fits.p_value is not None:
            lines.append(f"$A^2$ = {fits.anderson_darling:.2f}, {probability(fits.p_value)}")
        axes.text(0.025, 0.97, "\n".join(lines), transform=axes.transAxes, va="top", bbox=BOX)
        axes.legend(loc="lower right")
    else:
        labels = [f"{name}:  {_row(fit)}" for name, fit in groups.items()]
        labels.append(f"in brackets and shaded: {level} intervals; $p$: Anderson–Darling")
        draw_key(figure, [*axes.get_lines()[1::2], axes.plot([], [], " ")[0]], labels)
    if title is not None:
        axes.set_title(title)
    return figure


def _draw_group(
    axes: Axes, fit: WeibullFit, points: SurvivalPoints, colour: str, bottom: float, top: float
) -> np.ndarray:
    """Points, line and band; returns the abscissas of the line at ``bottom`` and ``top``."""
    ordinate = np.linspace(bottom, top, _BAND_POINTS)
    survival = np.exp(-np.exp(ordinate))
    low, high = (np.log(MEGA * edge) for edge in fit.strength_interval(survival))
    line = np.log(MEGA * fit.strength(survival))
    abscissa = points.abscissa + np.log(MEGA)
    many = points.strength.size > 200
    axes.plot(
        abscissa,
        points.ordinate,
        "o",
        color=colour,
        markerfacecolor="white",
        markersize=2.5 if many else 4.5,
        markeredgewidth=0.6 if many else 1.0,
        zorder=3,
        label="grains, mean ranks",
    )
    axes.plot(line, ordinate, color=colour, label="maximum likelihood")
    axes.fill_betweenx(
        ordinate,
        low,
        high,
        color=colour,
        alpha=0.15,
        linewidth=0,
        label=f"{100 * fit.confidence:g} % band",
    )
    return line[[0, -1]]


def _estimates(fit: WeibullFit, level: str = "") -> list[str]:
    """Size of the group, and both estimates with intervals, which ``level`` may name."""
    low, high = fit.sigma0_ci
    unbroken = "" if fit.broken == fit.n else f" ({fit.broken} broken)"
    return [
        f"$n$ = {fit.n}{unbroken}",
        f"$m$ = {significant(fit.modulus)} ({level}{interval(*fit.modulus_ci)})",
        rf"$\sigma_0$ = {significant(MEGA * fit.sigma0)} MPa"
        f" ({level}{interval(MEGA * low, MEGA * high)})",
    ]


def _row(fit: WeibullFit) -> str:
    tail = [] if fit.p_value is None else [probability(fit.p_value)]
    return ", ".join(_estimates(fit) + tail)


def _mark_characteristic_strength(axes: Axes, fit: WeibullFit) -> None:
    """Dotted lines from the axes to the point where 37 % survive."""
    abscissa = np.log(MEGA * fit.sigma0)
    left, bottom = axes.get_xlim()[0], axes.get_ylim()[0]
    axes.plot(
        [left, abscissa, abscissa], [0.0, 0.0, bottom], ":", color=GREY, linewidth=1.0, zorder=1
    )


def _mark_unbroken(axes: Axes, fit: WeibullFit) -> None:
    """Triangles on the upper edge: the largest stress of each grain that did not break."""
    stresses = MEGA * np.array(fit.strengths)[np.array(fit.censored)]
    if stresses.size:
        axes.plot(
            np.log(stresses),
            np.ones(stresses.size),
            ">",
            transform=axes.get_xaxis_transform(),
            color=GREY,
            clip_on=False,
            label="unbroken",
        )


def _label_axes(axes: Axes) -> None:
    axes.set_xlabel(r"Crushing strength $\sigma$ [MPa]")
    axes.set_ylabel("Survival probability $P_s$ [%]")
    ticks = log_ticks(*np.exp(axes.get_xlim()))
    axes.set_xticks(np.log(ticks), [f"{tick:g}" for tick in ticks])
    axes.set_yticks(*survival_ticks(*axes.get_ylim()))
    axes.secondary_xaxis("top").set_xlabel(r"$\ln(\sigma\,/\,1\,\mathrm{MPa})$ [–]")
    axes.secondary_yaxis("right").set_ylabel(r"$\ln(\ln(1/P_s))$ [–]")


def _widened(values: np.ndarray, share: float) -> tuple[float, float]:
    """Limits of the values, moved apart by this share of their distance at either end."""
    margin = share * np.ptp(values)
    return float(values.min() - margin), float(values.max() + margin)
