"""Void ratio and breakage against the logarithm of stress."""

from __future__ import annotations

import itertools
from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from grus.compression import BreakageOnset, YieldStress, first_loading
from grus.errors import GrusError
from grus.plotting.frame import SINGLE, draw_key, new_figure
from grus.plotting.labels import interval, log_ticks, significant
from grus.plotting.style import BLACK, PALETTE, style

Curves = Mapping[str, tuple[np.ndarray, np.ndarray]]

_FEW = 40
"""Readings up to this number are marked one by one."""

_BEYOND = 1.15
"""By which factor of stress the lines are drawn past the point where they meet."""
_DASHES = {"linestyle": (0, (4, 2.5)), "color": BLACK, "linewidth": 0.9, "zorder": 3.5}


@style()
def compression_plot(
    curves: Curves,
    yields: Mapping[str, YieldStress | None] | None = None,
    normalised: bool = False,
    title: str | None = None,
    size: tuple[float, float] = SINGLE,
    reference: float | None = None,
) -> Figure:
    """Compression curves of one or several tests by name, yield marked, unloading in thin lines.

    curves: stress [Pa] (n,) and void ratio [-] (n,) of each, in the order of the test. yields: of
    those that have one: the lines that meet there are dashed, the interval is shaded. normalised: void ratios are
    divided by that of the first reading at a stress above zero. reference: void ratio e0 of a second axis of e/e0.

    Raises GrusError for no curves, unequal columns, and a yield of a name that is no curve's.
    """
    columns = _checked(curves, yields)
    figure, axes = new_figure(size, key_rows=1 + len(columns))
    factor, unit = _unit(columns)
    lines, labels = [], []
    for (name, (stress, value)), colour in zip(columns.items(), itertools.cycle(PALETTE)):
        scale = 1.0 / value[0] if normalised else 1.0
        lines.append(_draw_path(axes, factor * stress, scale * value, colour))
        found = (yields or {}).get(name)
        if found is not None:
            _mark(axes, factor, found.stress, found.interval, scale * found.void_ratio, colour)
            for reach, index in (
                ([stress.min(), _BEYOND * found.stress], found.index_before),
                ([found.stress / _BEYOND, stress.max()], found.compression_index),
            ):
                line = found.void_ratio - index * np.log10(np.array(reach) / found.stress)
                axes.plot(factor * np.array(reach), scale * line, **_DASHES)
        labels.append(_row(name, "yield", found, factor, unit))
    _label_stress(axes, columns, factor, unit)
    axes.set_ylabel("Void ratio $e/e_0$ [–]" if normalised else "Void ratio $e$ [–]")
    if reference is not None:
        shares = (lambda e: e / reference, lambda share: share * reference)
        axes.secondary_yaxis("right", functions=shares).set_ylabel("Void ratio $e/e_0$ [–]")
    marked = any(found is not None for found in (yields or {}).values())
    note = "dashed: lines that meet at yield; shaded: its interval" if marked else ""
    return _finished(figure, axes, lines, labels, note, title)


@style()
def breakage_plot(
    curves: Curves,
    onsets: Mapping[str, BreakageOnset] | None = None,
    quantity: str = "Bonds broken",
    title: str | None = None,
    size: tuple[float, float] = SINGLE,
) -> Figure:
    """Breakage of one or several tests by name; the onset of sustained breakage marked.

    curves: stress [Pa] (n,) and breakage (n,) of each, in the order of the test. onsets: the line
    from each is dashed, its interval is shaded; a triangle marks the first breakage. quantity:
    what is counted, for the axis.

    Raises GrusError as `compression_plot`.
    """
    columns = _checked(curves, onsets)
    figure, axes = new_figure(size, key_rows=1 + len(columns))
    factor, unit = _unit(columns)
    lines, labels = [], []
    for (name, (stress, value)), colour in zip(columns.items(), itertools.cycle(PALETTE)):
        lines.append(_draw_path(axes, factor * stress, value, colour))
        found = (onsets or {}).get(name)
        if found is not None and found.stress is not None:
            reach = np.array([found.stress, stress.max()])
            _mark(axes, factor, found.stress, found.interval, found.broken, colour)
            axes.plot(factor * reach, found.line(reach), **_DASHES)
        labels.append(_row(name, "onset", found, factor, unit))
        if found is not None and found.first_break is not None:
            first = factor * found.first_break
            axes.plot(
                first,
                0.0,
                "^",
                color=colour,
                markersize=6,
                transform=axes.get_xaxis_transform(),
                clip_on=False,
                zorder=5,
            )
            labels[-1] += f";  first breakage {significant(first)} {unit}"
    _label_stress(axes, columns, factor, unit)
    axes.set_ylabel(quantity)
    axes.set_ylim(bottom=min(0.0, *(value.min() for _, value in columns.values())))
    note = "triangle: first breakage; dashed: from the onset on; shaded: its interval"
    return _finished(figure, axes, lines, labels, note if onsets else "", title)


def _checked(curves: Curves, marks: Mapping | None) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """Columns without the readings at stresses that have no place on a logarithmic axis."""
    if not curves:
        raise GrusError("curves: none given; a plot needs at least one")
    for name in marks or {}:
        if name not in curves:
            raise GrusError(f"marks: {name!r} is no curve; must be one of {', '.join(curves)}")
    result = {}
    for name, pair in curves.items():
        stress, value = (np.asarray(column, dtype=float) for column in pair)
        if stress.ndim != 1 or stress.shape != value.shape:
            raise GrusError(
                f"curves: {name!r} has columns of shapes {stress.shape} and {value.shape}; "
                "must be of one length"
            )
        if not (stress > 0).any():
            raise GrusError(f"curves: {name!r} has no stress above zero; must have one at least")
        result[name] = stress[stress > 0], value[stress > 0]
    return result


def _draw_path(axes: Axes, stress: np.ndarray, value: np.ndarray, colour: str) -> Line2D:
    """The whole path thin, first loading strong; returns the strong line."""
    axes.plot(stress, value, color=colour, lw=0.8, alpha=0.7)
    first = first_loading(stress)
    marker = "o" if first.sum() <= _FEW else ""
    return axes.plot(
        stress[first], value[first], color=colour, marker=marker, markersize=3.8, zorder=3
    )[0]


def _mark(
    axes: Axes,
    factor: float,
    stress: float,
    limits: tuple[float, float],
    level: float,
    colour: str,
) -> None:
    axes.axvspan(factor * limits[0], factor * limits[1], color=colour, alpha=0.13, lw=0)
    axes.plot(
        factor * stress,
        level,
        "D",
        color=colour,
        markersize=6,
        markeredgecolor="black",
        markeredgewidth=0.8,
        zorder=4,
    )


def _unit(columns: Mapping[str, tuple[np.ndarray, np.ndarray]]) -> tuple[float, str]:
    highest = max(stress.max() for stress, _ in columns.values())
    return (1e-6, "MPa") if highest > 5e6 else (1e-3, "kPa")


def _row(
    name: str, what: str, found: YieldStress | BreakageOnset | None, factor: float, unit: str
) -> str:
    if found is None:
        return name
    if found.stress is None:
        return f"{name}:  no {what}"
    low, high = (factor * limit for limit in found.interval)
    return (
        f"{name}:  {what} {significant(factor * found.stress)} {unit}"
        f" ({100 * found.confidence:g} %: {interval(low, high)})"
    )


def _label_stress(axes: Axes, columns: Mapping, factor: float, unit: str) -> None:
    lowest = factor * min(_lowest(stress) for stress, _ in columns.values())
    highest = factor * max(stress.max() for stress, _ in columns.values())
    margin = (highest / lowest) ** 0.03
    axes.set_xscale("log")
    axes.set_xlim(lowest / margin, highest * margin)
    ticks = log_ticks(*axes.get_xlim())
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.set_xticks([], minor=True)
    axes.set_xlabel(rf"Axial stress $\sigma$ [{unit}]")


def _lowest(stress: np.ndarray) -> float:
    """Of first loading and of what follows the highest stress; drops while grains break are cut off."""
    return min(stress[0], stress[stress.argmax() :].min())


def _finished(
    figure: Figure,
    axes: Axes,
    lines: list[Line2D],
    labels: list[str],
    note: str,
    title: str | None,
) -> Figure:
    if not note:
        draw_key(figure, lines, labels)
    else:
        draw_key(figure, [*lines, axes.plot([], [], " ")[0]], [*labels, note])
    if title is not None:
        axes.set_title(title)
    return figure
