"""Grading curves before and after the stages of a test."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from grus.errors import GrusError
from grus.grading import Grading
from grus.plotting.frame import draw_key, new_figure
from grus.plotting.labels import MILLI, log_ticks, significant
from grus.plotting.style import BLACK, GREY, style

TALL = (5.2, 5.0)
"""Width and height in inches of a figure of two panels, its key not included."""


@style()
def grading_plot(
    gradings: Mapping[str, Grading], title: str | None = None, size: tuple[float, float] = TALL
) -> Figure:
    """Gradings by name in the order of the test; below, the change of each against the first.

    Sizes in mm on a logarithmic axis. The first curve is black, the later ones go from light to
    dark. One grading alone has no lower panel.

    Raises GrusError when there is no grading.
    """
    if not gradings:
        raise GrusError("gradings: none given; a grading plot needs at least one")
    figure, axes = new_figure(size, key_rows=2 + len(gradings))  # rows with subscripts are taller
    panels = [axes]
    if len(gradings) > 1:
        axes.remove()
        panels = figure.subplots(2, 1, sharex=True, gridspec_kw={"height_ratios": [2.6, 1.0]})
    before = next(iter(gradings.values()))
    lines = []
    for grading, colour in zip(gradings.values(), _colours(len(gradings))):
        lines += panels[0].plot(
            MILLI * grading.sizes,
            grading.passing,
            "o-",
            color=colour,
            linewidth=2.6 if grading is before else 1.4,
            markersize=3.2 if len(grading.sizes) <= 40 else 0,
            markerfacecolor="white",
        )
        if grading is not before:
            sizes, change = _change(before, grading)
            panels[1].plot(MILLI * sizes, change, color=colour, lw=1.3)
    _label(panels, list(gradings.values()))
    labels = [f"{name}:  {_row(grading)}" for name, grading in gradings.items()]
    labels.append(r"$D_{50}$, $D_{10}$ in mm; $C_u$ = $D_{60}/D_{10}$")
    draw_key(figure, [*lines, panels[0].plot([], [], " ")[0]], labels)
    if title is not None:
        panels[0].set_title(title)
    return figure


def _colours(count: int) -> list:
    later = colormaps["plasma_r"](np.linspace(0.22, 0.8, max(count - 1, 1)))
    return [BLACK, *later][:count]


def _change(before: Grading, after: Grading) -> tuple[np.ndarray, np.ndarray]:
    """Sizes (k,) [m] where both curves are known, and the change of passing (k,) [%]."""
    sizes = np.union1d(before.sizes, after.sizes)
    for grading in (before, after):
        if grading.passing[0] > 0:
            sizes = sizes[sizes >= grading.sizes[0]]
    return sizes, after.passing_at(sizes) - before.passing_at(sizes)


def _label(panels: list[Axes], gradings: list[Grading]) -> None:
    low = min(grading.sizes[0] for grading in gradings)
    high = max(grading.size_at(100) for grading in gradings)
    margin = (high / low) ** 0.03
    for axes in panels:
        axes.set_xscale("log")
    panels[0].set_xlim(MILLI * low / margin, MILLI * high * margin)
    ticks = log_ticks(*panels[0].get_xlim())
    for axes in panels:
        axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
        axes.set_xticks([], minor=True)
    panels[0].set_ylim(-3, 103)
    panels[0].set_yticks(range(0, 101, 20))
    panels[0].set_ylabel("Passing by mass [%]")
    panels[-1].set_xlabel("Size $d$ [mm]")
    if len(panels) > 1:
        panels[1].axhline(0.0, color=GREY, lw=0.8)
        panels[1].set_ylabel("Change [%]")
        panels[0].tick_params(labelbottom=False)


def _row(grading: Grading) -> str:
    parts = [rf"$D_{{50}}$ {significant(MILLI * grading.d50)}"] if grading.passing[0] < 50 else []
    if grading.passing[0] <= 10:
        parts.append(rf"$D_{{10}}$ {significant(MILLI * grading.d10)}")
        parts.append(rf"$C_u$ {significant(grading.uniformity)}")
    return ", ".join(parts)
