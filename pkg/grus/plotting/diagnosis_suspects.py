"""Probabilities of all that may have been left out."""

from __future__ import annotations

from collections.abc import Mapping

from matplotlib.figure import Figure

from grus.plotting.frame import new_figure
from grus.plotting.style import GREY, SKY, VERMILION, style

WIDTH, ROW = 6.4, 0.27
"""Width, and height of a bar, in inches."""


@style()
def suspects_plot(
    probability: Mapping[str, float],
    named: frozenset[str],
    threshold: float,
    missing: Mapping[str, str],
) -> Figure:
    """A bar a suspect, in the order given. named: those of the verdict. threshold: from which one is named.
    missing: suspects without a probability, and why."""
    names = [*probability, *missing]
    figure, axes = new_figure((WIDTH, 0.8 + ROW * len(names)))
    for row, (name, value) in enumerate(probability.items()):
        axes.barh(row, 100 * value, color=VERMILION if name in named else SKY, height=0.66)
        text = "> 99 %" if value > 0.99 else f"{100 * value:.0f} %"
        text = "< 1 %" if value < 0.01 else text
        axes.text(100 * value + 1, row, text, va="center", fontsize=8)
    for row, why in enumerate(missing.values(), len(probability)):
        axes.text(1, row, why, va="center", fontsize=8, color=GREY)
    axes.axvline(100 * threshold, color=GREY, ls="--", lw=1)
    axes.text(
        100 * threshold - 1,
        len(names) - 0.6,
        "named from here on",
        ha="right",
        fontsize=8,
        color=GREY,
    )
    axes.set_ylim(len(names) - 0.4, -0.6)
    axes.set_yticks(range(len(names)), names)
    axes.tick_params(axis="y", length=0)
    axes.set_xlim(0, 120)
    axes.set_xticks([0, 25, 50, 75, 100])
    axes.set_xlabel("Probability [%]")
    axes.grid(axis="y", visible=False)
    return figure
