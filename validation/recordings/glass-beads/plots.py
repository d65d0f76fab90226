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


LINES = {"linear": ":", "Hertz": "-"}


@style()
def curve_plot(recorded: Branches, simulated: dict[str, Branches]) -> Figure:
    """Axial strain and lateral stress against axial stress, recorded and simulated with each contact law."""
    figure, axes = new_figure((8.4, 4.1), key_rows=len(COLOURS) + 1 + len(LINES))
    axes.remove()
    left, right = figure.subplots(1, 2)
    for axes, name, factor, label in (
        (left, "axial_strain", 100, "Axial strain [%]"),
        (right, "lateral_stress", 1e-6, "Lateral stress [MPa]"),
    ):
        for branch, colour in COLOURS.items():
            real = recorded[branch]
            axes.plot(1e-6 * real["axial_stress"], factor * real[name], ".", color=colour, ms=4)
            for law, line in LINES.items():
                own = simulated[law][branch]
                axes.plot(1e-6 * own["axial_stress"], factor * own[name], line, color=colour)
        axes.set_xlabel("Axial stress [MPa]")
        axes.set_ylabel(label)
    left.invert_yaxis()
    key = [Line2D([], [], color=colour) for colour in COLOURS.values()]
    key.append(Line2D([], [], color=BLACK, marker=".", linestyle=""))
    key += [Line2D([], [], color=BLACK, linestyle=line) for line in LINES.values()]
    draw_key(figure, key, [*COLOURS, "recorded", *(f"simulated, {law}" for law in LINES)])
    return figure


@style()
def residual_plot(recorded: Branches, simulated: dict[str, Branches]) -> Figure:
    """Simulated less recorded axial strain against axial stress, with each contact law."""
    figure, axes = new_figure((8.4, 3.9), key_rows=len(COLOURS))
    axes.remove()
    for axes, law in zip(figure.subplots(1, len(LINES), sharey=True), LINES):
        for branch, colour in COLOURS.items():
            stress = recorded[branch]["axial_stress"]
            own = simulated[law][branch]
            order = np.argsort(own["axial_stress"])
            strain = np.interp(stress, own["axial_stress"][order], own["axial_strain"][order])
            away = 100 * (strain - recorded[branch]["axial_strain"])
            axes.plot(1e-6 * stress, away, ".-", color=colour, label=branch)
        axes.axhline(0, color=BLACK, lw=0.8)
        axes.set_xlabel("Axial stress [MPa]")
        axes.set_title(f"{law} contacts")
    figure.axes[0].set_ylabel("Simulated less recorded axial strain [%]")
    draw_key(figure, *axes.get_legend_handles_labels())
    return figure
