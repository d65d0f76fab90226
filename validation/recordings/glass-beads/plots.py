"""Figures of the comparison with the glass beads."""

import numpy as np
from grus.plotting import style
from grus.plotting.frame import draw_key, new_figure
from grus.plotting.style import BLACK, BLUE, GREEN, ORANGE, SKY
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

COLOURS = dict(
    zip(("loading", "unloading", "reloading", "second unloading"), (BLUE, ORANGE, SKY, GREEN))
)
Branches = dict[str, dict[str, np.ndarray]]


@style()
def curve_plot(recorded: Branches, simulated: Branches) -> Figure:
    """Axial strain and lateral stress against axial stress, recorded and simulated."""
    figure, axes = new_figure((8.4, 3.9), key_rows=len(COLOURS) + 1)
    axes.remove()
    left, right = figure.subplots(1, 2)
    for axes, name, factor, label in (
        (left, "axial_strain", 100, "Axial strain [%]"),
        (right, "lateral_stress", 1e-6, "Lateral stress [MPa]"),
    ):
        for branch, colour in COLOURS.items():
            real, own = recorded[branch], simulated[branch]
            axes.plot(1e-6 * real["axial_stress"], factor * real[name], ".", color=colour, ms=4)
            axes.plot(1e-6 * own["axial_stress"], factor * own[name], color=colour)
        axes.set_xlabel("Axial stress [MPa]")
        axes.set_ylabel(label)
    left.invert_yaxis()
    key = [Line2D([], [], color=colour) for colour in COLOURS.values()]
    points = Line2D([], [], color=BLACK, marker=".", linestyle="")
    draw_key(figure, [*key, points], [*COLOURS, "dots: recorded; lines: simulated"])
    return figure


@style()
def residual_plot(recorded: Branches, simulated: Branches) -> Figure:
    """Simulated less recorded axial strain against axial stress."""
    figure, axes = new_figure(key_rows=len(COLOURS))
    for branch, colour in COLOURS.items():
        stress = recorded[branch]["axial_stress"]
        own = simulated[branch]
        order = np.argsort(own["axial_stress"])
        strain = np.interp(stress, own["axial_stress"][order], own["axial_strain"][order])
        away = 100 * (strain - recorded[branch]["axial_strain"])
        axes.plot(1e-6 * stress, away, ".-", color=colour, label=branch)
    axes.axhline(0, color=BLACK, lw=0.8)
    axes.set_xlabel("Axial stress [MPa]")
    axes.set_ylabel("Simulated less recorded axial strain [%]")
    draw_key(figure, *axes.get_legend_handles_labels())
    return figure
