"""Pictures of crushed grains."""

from collections.abc import Sequence
from dataclasses import replace
from math import ceil

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PatchCollection
from matplotlib.figure import Figure
from matplotlib.patches import Circle

from grus.crushing.result import CrushingResult
from grus.plotting.style import BLACK, PALETTE, VERMILION, style
from grus.specimen.draw import draw

MODES = {1: (VERMILION, "broken in tension"), 2: (BLACK, "broken in shear")}
DUST = "#D9D9D9"  # fragments of a single clump or element
MOST = 12  # grains in one picture


@style()
def fragment_picture(results: Sequence[CrushingResult], size: float = 2.6) -> Figure:
    """The first grains of a group after their tests, one panel each, coloured by fragment."""
    shown = list(results)[:MOST]
    columns = min(4, len(shown))
    rows = ceil(len(shown) / columns)
    figure = Figure(figsize=(size * columns, size * rows * 1.12), layout="constrained")
    panels = figure.subplots(rows, columns, squeeze=False).ravel()
    for axes, result in zip(panels, shown):
        draw_fragments(axes, result)
        axes.set_title(f"grain {result.grain}: {result.strength / 1e6:.2f} MPa", fontsize=9)
    for axes in panels[len(shown) :]:
        axes.set_axis_off()
    return figure


def draw_fragments(axes: Axes, result: CrushingResult) -> None:
    """The end of one test; a plane grain with its broken bonds, a grain in space as it is seen."""
    if result.specimen.dimension == 3:
        draw(replace(result.specimen, position=result.after.position), axes)
    else:
        _draw_discs(axes, result)
        _draw_broken(axes, result)
    axes.set_xticks([])
    axes.set_yticks([])
    axes.set_xlabel("")
    axes.set_ylabel("")
    axes.grid(False)


def _draw_discs(axes: Axes, result: CrushingResult) -> None:
    clumps = [
        len(np.unique(result.specimen.clump[result.after.fragment == f]))
        for f in range(result.after.fragment_count)
    ]
    colours = [
        PALETTE[f % (len(PALETTE) - 1)] if clumps[f] > 1 else DUST for f in range(len(clumps))
    ]
    discs = [
        Circle(xy, r)
        for xy, r in zip(1e3 * result.after.position[:, :2], 1e3 * result.specimen.radius)
    ]
    face = [colours[f] for f in result.after.fragment]
    axes.add_collection(PatchCollection(discs, facecolor=face, edgecolor="white", linewidth=0.4))
    half = 0.75e3 * result.gap
    axes.set(xlim=(-half, half), ylim=(-half, half), aspect="equal")
    gap = result.gap - result.record["closing"][-1]
    for side in (-0.5, 0.5):
        axes.axhline(1e3 * side * gap + _middle(result), color=BLACK, linewidth=2)


def _middle(result: CrushingResult) -> float:
    """Height of the plane midway between the platens [mm], which both move at the same speed."""
    height, radius = result.before.position[:, 1], result.specimen.radius
    return 0.5e3 * float((height - radius).min() + (height + radius).max())


def _draw_broken(axes: Axes, result: CrushingResult) -> None:
    """A stroke across each broken bond whose elements still touch, as a crack would be seen."""
    for mode, (colour, label) in MODES.items():
        pairs = result.after.broken[result.after.mode == mode]
        ends = 1e3 * result.after.position[pairs][:, :, :2]
        middle, along = ends.mean(axis=1), ends[:, 1] - ends[:, 0]
        across = 0.35 * np.column_stack([-along[:, 1], along[:, 0]])
        strokes = np.stack([middle - across, middle + across], axis=1)
        axes.add_collection(LineCollection(strokes, colors=colour, linewidths=1.2, label=label))
