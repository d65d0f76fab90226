"""Pictures of crushed grains."""

from collections.abc import Sequence
from dataclasses import replace
from math import ceil

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PatchCollection
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Circle, Patch

from grus.crushing.result import CrushingResult
from grus.plotting.style import BLACK, PALETTE, VERMILION, style
from grus.specimen.draw import draw

MODES = {1: (VERMILION, "broken in tension"), 2: (BLACK, "broken in shear")}
DUST = "#D9D9D9"  # fragments of a single clump or element
MOST = 12  # grains in one picture


@style()
def fragment_picture(results: Sequence[CrushingResult], size: float = 2.6) -> Figure:
    """The first grains of a group after their tests, one panel each, coloured by fragment, all to one scale."""
    shown = list(results)[:MOST]
    columns = min(4, len(shown))
    rows = ceil(len(shown) / columns)
    height = size * rows * 1.12
    figure = Figure(figsize=(size * columns, height + 0.35), layout="constrained")
    figure.get_layout_engine().set(h_pad=0.08)
    above, below = figure.subfigures(2, 1, height_ratios=(height, 0.35))
    panels = above.subplots(rows, columns, squeeze=False).ravel()
    half = 0.75e3 * max(result.gap for result in shown)
    for axes, result in zip(panels, shown):
        draw_fragments(axes, result, half)
        axes.set_title(f"grain {result.grain}: {result.strength / 1e6:.2f} MPa", fontsize=9)
    for axes in panels[len(shown) :]:
        axes.set_axis_off()
    plane = shown[0].specimen.dimension == 2
    below.legend(handles=_key(plane), loc="center", ncols=4 if columns > 2 else 2, frameon=False)
    return figure


def _key(plane: bool) -> list[Artist]:
    """What the colours mean; broken bonds are seen in plane grains only."""
    fragment = Patch(facecolor=PALETTE[0], label="one colour a fragment")
    single = Patch(facecolor=DUST, label="single clumps")
    cracks = [Line2D([], [], color=c, label=f"bond {text}") for c, text in MODES.values()]
    return [fragment, single, *cracks] if plane else [fragment, single]


def draw_fragments(axes: Axes, result: CrushingResult, half: float | None = None) -> None:
    """The end of one test; a plane grain with its broken bonds, a grain in space as it is seen.

    half: what is shown to each side of the middle [mm]; three quarters of the initial gap when None.
    """
    half = 0.75e3 * result.gap if half is None else half
    colour = _fragment_colours(result)
    if result.specimen.dimension == 3:
        draw(replace(result.specimen, position=result.after.position), axes, colour=colour)
    else:
        _draw_discs(axes, result, colour)
        _draw_broken(axes, result)
    axes.set(xlim=(-half, half), ylim=(-half, half), aspect="equal")
    axes.set_xticks([])
    axes.set_yticks([])
    axes.set_xlabel("")
    axes.set_ylabel("")
    axes.grid(False)


def _fragment_colours(result: CrushingResult) -> np.ndarray:
    """Red, green and blue (n, 3) of each element: its fragment's, grey where that is a single clump."""
    fragment = result.after.fragment
    pairs = np.unique(np.column_stack([fragment, result.specimen.clump]), axis=0)
    clumps = np.bincount(pairs[:, 0])
    hues = np.array([to_rgb(colour) for colour in PALETTE[:-1]])  # the last one is for cracks
    colours = np.where(
        (clumps > 1)[:, None], hues[np.arange(len(clumps)) % len(hues)], to_rgb(DUST)
    )
    return colours[fragment]


def _draw_discs(axes: Axes, result: CrushingResult, colour: np.ndarray) -> None:
    places = 1e3 * result.after.position[:, :2]
    discs = [Circle(xy, r) for xy, r in zip(places, 1e3 * result.specimen.radius)]
    axes.add_collection(PatchCollection(discs, facecolor=colour, edgecolor="white", linewidth=0.4))
    gap = result.gap - result.record["closing"][-1]
    for side in (-0.5, 0.5):
        axes.axhline(1e3 * side * gap + _middle(result), color=BLACK, linewidth=2)


def _middle(result: CrushingResult) -> float:
    """Height of the plane midway between the platens [mm], which both move at the same speed."""
    height, radius = result.before.position[:, 1], result.specimen.radius
    return 0.5e3 * float((height - radius).min() + (height + radius).max())


def _draw_broken(axes: Axes, result: CrushingResult) -> None:
    """A stroke across each broken bond whose elements still touch, as a crack would be seen."""
    for mode, (colour, _) in MODES.items():
        pairs = result.after.broken[result.after.mode == mode]
        ends = 1e3 * result.after.position[pairs][:, :, :2]
        middle, along = ends.mean(axis=1), ends[:, 1] - ends[:, 0]
        across = 0.35 * np.column_stack([-along[:, 1], along[:, 0]])
        strokes = np.stack([middle - across, middle + across], axis=1)
        axes.add_collection(LineCollection(strokes, colors=colour, linewidths=1.2))
