"""Pictures of the specimen of an oedometer test: crushed grains and force chains."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import EllipseCollection, LineCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from grus.oedometer.result import OedometerResult, StageEnd
from grus.plotting.frame import draw_key, new_figure
from grus.plotting.labels import prefixed
from grus.plotting.style import BLACK, BLUE, VERMILION, style
from grus.scene.contacts import NO_ELEMENT
from grus.specimen import Specimen
from grus.specimen.draw import PALETTE, clump_colours, draw
from grus.specimen.touching import touching_pairs

BACKGROUND = "#E9E9E9"
PALE = 0.62
"""Share of white in the colour of what is left of a grain."""
WIDE = 5.2
"""Width of a picture [inch]."""
TITLE = 0.35
"""Height of the title [inch]."""
VIEW = (8.0, -75.0)
"""Elevation and azimuth from which a specimen in space is seen [degrees]."""
MANY = 2000
"""Elements from which on SVG files hold pictures of them, not shapes."""
WIDEST = {2: 0.7, 3: 0.3}
"""Width of the widest line of a force, over the diameter of an element, in the plane and in space."""
STRONG = 0.998
"""Share of the contacts whose force is below that of the widest line."""
WEAK = 0.02
"""Forces below this share of that one are left out."""


@style()
def crushed_picture(result: OedometerResult, end: StageEnd) -> Figure:
    """The specimen at the end of a stage: grains in pale colours, what has left them in strong ones."""
    specimen = replace(result.prepared.specimen, position=end.state.position)
    figure, axes = new_figure((WIDE, _height(specimen)), key_rows=2)
    axes.set_title(f"{result.card.name}, {end.name}")
    pieces = replace(specimen, clump=end.state.fragment)
    draw(pieces, axes, colour=_colours(specimen, end), view=VIEW)
    _frame(axes, specimen)
    away = _away(specimen, end)
    count = len(np.unique(end.state.fragment[away]))
    key = [
        Patch(facecolor=_pale(PALETTE[0]), label="largest fragment of a grain"),
        Patch(facecolor=PALETTE[0], label=f"what has broken away from it ({count} fragments)"),
    ]
    draw_key(figure, key, [one.get_label() for one in key])
    return figure


@style()
def force_chain_picture(result: OedometerResult, ends: Sequence[StageEnd]) -> Figure:
    """Normal forces of all contacts and bonds at the ends of stages, a panel each: lines as wide as the force is large."""
    specimens = [replace(result.prepared.specimen, position=end.state.position) for end in ends]
    figure, axes = new_figure((WIDE * len(ends), _height(specimens[0])), key_rows=2)
    axes.remove()
    panels = figure.subplots(1, len(ends), squeeze=False)[0]
    for axes, specimen, end in zip(panels, specimens, ends):
        strong = _draw_forces(axes, specimen, end)
        factor, unit = prefixed(strong, "N")
        axes.set_title(f"{result.card.name}, {end.name}: widest line {factor * strong:.3g} {unit}")
        _frame(axes, specimen)
    key = [
        Line2D([], [], color=BLUE, linewidth=2, label="compression"),
        Line2D([], [], color=VERMILION, linewidth=2, label="tension in bonds"),
    ]
    draw_key(figure, key, [one.get_label() for one in key])
    return figure


def _height(specimen: Specimen) -> float:
    """Height of a picture with its title [inch]."""
    across, up = np.ptp(_seen(specimen, specimen.position), axis=0)
    return float(WIDE * up / across + TITLE)


def _seen(specimen: Specimen, points: np.ndarray) -> np.ndarray:
    """Points (n, 2) [mm] of the picture, of points (n, 3) [m]; in space from the front."""
    return 1e3 * points[:, [0, specimen.dimension - 1]]


def _frame(axes: Axes, specimen: Specimen) -> None:
    """No axes, and pictures instead of shapes in vector files of large specimens."""
    axes.set_axis_off()
    axes.set_aspect("equal")
    if specimen.element_count > MANY:
        axes.set_rasterization_zorder(10)


def _away(specimen: Specimen, end: StageEnd) -> np.ndarray:
    """Mask (n,) of the elements that are not of the largest fragment of their grain."""
    fragment = end.state.fragment
    size = np.bincount(fragment)
    order = np.lexsort((fragment, -size[fragment], specimen.grain))
    first = order[np.unique(specimen.grain[order], return_index=True)[1]]
    return fragment != fragment[first][specimen.grain]


def _pale(colour: np.ndarray) -> np.ndarray:
    return PALE + (1 - PALE) * colour


def _colours(specimen: Specimen, end: StageEnd) -> np.ndarray:
    """Red, green and blue (n, 3): grains that touch differ."""
    pairs = touching_pairs(specimen.position, specimen.radius)
    own = PALETTE[clump_colours(replace(specimen, clump=specimen.grain), pairs)][specimen.grain]
    return np.where(_away(specimen, end)[:, None], own, _pale(own))


def _draw_forces(axes: Axes, specimen: Specimen, end: StageEnd) -> float:
    """Returns the force of the widest line [N]."""
    contacts = end.contacts
    places = _seen(specimen, specimen.position)
    second = places[contacts.pairs[:, 1]]
    first = np.where(
        (contacts.pairs[:, 0] == NO_ELEMENT)[:, None],
        _seen(specimen, contacts.point),
        places[contacts.pairs[:, 0]],
    )
    size = np.abs(contacts.force)
    strong = float(np.quantile(size, STRONG)) or 1.0
    shown = np.flatnonzero(size > WEAK * strong)
    shown = shown[np.argsort(size[shown], kind="stable")]
    low, high = places.min(axis=0), places.max(axis=0)
    margin = 2e3 * specimen.radius.max()
    axes.set(xlim=(low[0] - margin, high[0] + margin), ylim=(low[1] - margin, high[1] + margin))
    points_per_mm = 72 * WIDE / (high[0] - low[0] + 2 * margin)
    widest = WIDEST[specimen.dimension] * 2e3 * float(specimen.radius.mean()) * points_per_mm
    lines = LineCollection(
        np.stack([first, second], axis=1)[shown],
        linewidths=widest * np.minimum(size[shown] / strong, 1),
        colors=np.where(contacts.force[shown] > 0, BLUE, VERMILION),
        capstyle="round",
        zorder=2,
    )
    axes.add_collection(lines)
    axes.add_collection(
        EllipseCollection(
            2e3 * specimen.radius,
            2e3 * specimen.radius,
            np.zeros(specimen.element_count),
            units="xy",
            offsets=places,
            offset_transform=axes.transData,
            facecolors=BACKGROUND,
            linewidths=0,
            zorder=1,
        )
    )
    axes.plot(*_outline(low, high, margin), color=BLACK, linewidth=1)
    return strong


def _outline(low: np.ndarray, high: np.ndarray, margin: float) -> tuple[list, list]:
    """The walls around centres between `low` and `high` (2,) [mm], an element radius outside of them."""
    (x, y), (right, top) = low - margin / 2, high + margin / 2
    return [x, right, right, x, x], [y, y, top, top, y]
