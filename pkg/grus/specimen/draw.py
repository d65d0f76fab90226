"""Pictures of specimens."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import EllipseCollection, LineCollection, PolyCollection
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

from grus.specimen.require import require
from grus.specimen.specimen import Specimen
from grus.specimen.touching import touching_pairs

# Stone colours that stay apart for colour-blind readers, by lightness as well as by hue.
PALETTE = np.array(
    [
        to_rgb(colour)
        for colour in (
            "#4E79A7", "#E8B365", "#86BCB6", "#B6635A", "#D7CDB8",
            "#7A8F4B", "#9D7FA6", "#A9C3DC", "#8C6D52", "#C9D39B",
        )
    ]
)  # fmt: skip
BOND_COLOUR = "#1F2328"
LIGHT = np.array([-0.45, 0.60])
"""Direction of the light in the picture, to the upper left."""


def draw(
    specimen: Specimen,
    axes: Axes | None = None,
    *,
    bonds: bool = False,
    colour: np.ndarray | None = None,
    view: tuple[float, float] = (20.0, 30.0),
) -> Axes:
    """Draw the elements, coloured by clump so that clumps that touch differ, or in the colours given.

    colour (n, 3): red, green and blue of each element, 0 to 1; None: by clump.

    A plane specimen is drawn as discs, the discs of a clump joined by webs; `bonds` adds a stitch
    across each bonded contact. A specimen in space is drawn as shaded spheres in parallel
    projection, seen from `view` = (elevation above the xy plane, azimuth from the x axis)
    [degrees], z upwards. Lengths on the axes are in mm.
    Returns the axes; when none are given, those of a new figure outside pyplot
    (`axes.figure.savefig` writes it).
    Raises GrusError when bonds are asked for in space, where spheres hide them.
    """
    require(not bonds or specimen.dimension == 2, "bonds", bonds, "False for a specimen in space")
    if axes is None:
        axes = Figure(figsize=(5, 5), layout="constrained").add_subplot()
    pairs = touching_pairs(specimen.position, specimen.radius)
    if colour is None:
        colour = PALETTE[clump_colours(specimen, pairs)][specimen.clump]
    if specimen.dimension == 2:
        seen = 1e3 * specimen.position[:, :2]
        _draw_discs(axes, specimen, seen, colour, pairs)
        if bonds:
            _draw_bonds(axes, seen[specimen.bonds()])
        axes.set(xlabel="x [mm]", ylabel="y [mm]")
    else:
        seen = _draw_spheres(axes, specimen, colour, np.radians(view))
        axes.axis("off")
    edge = 1e3 * specimen.radius[:, None] * 1.3
    low, high = (seen - edge).min(axis=0), (seen + edge).max(axis=0)
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
    return axes


def clump_colours(specimen: Specimen, pairs: np.ndarray) -> np.ndarray:
    """Index (m,) into the palette: greedy colouring, the least used of the free colours."""
    links = np.unique(np.sort(specimen.clump[pairs], axis=1), axis=0)
    links = links[links[:, 0] != links[:, 1]]
    # Each clump looks at its neighbours of lower number, which are coloured by then.
    links = links[np.argsort(links[:, 1], kind="stable")]
    start = np.searchsorted(links[:, 1], np.arange(specimen.clump_count + 1))
    used = np.zeros(len(PALETTE))
    colour = np.zeros(specimen.clump_count, dtype=np.int64)
    for clump in range(specimen.clump_count):
        taken = np.bincount(
            colour[links[start[clump] : start[clump + 1], 0]], minlength=len(PALETTE)
        )
        colour[clump] = np.lexsort((used, taken))[0]
        used[colour[clump]] += 1
    return colour


def _draw_discs(
    axes: Axes, specimen: Specimen, seen: np.ndarray, colour: np.ndarray, pairs: np.ndarray
) -> None:
    """Discs with a darker rim, and webs over the contacts inside clumps."""
    inside = pairs[specimen.clump[pairs[:, 0]] == specimen.clump[pairs[:, 1]]]
    start, end = seen[inside[:, 0]], seen[inside[:, 1]]
    along = (end - start) / np.linalg.norm(end - start, axis=1, keepdims=True)
    radius = 1e3 * specimen.radius
    # Just wide enough to close the hole between three discs, 0.577 radii from their contacts.
    half = 0.60 * radius[inside].min(axis=1, keepdims=True) * along[:, ::-1] * [-1.0, 1.0]
    webs = np.stack([start - half, start + half, end + half, end - half], axis=1)
    _add_circles(axes, seen, radius, 0.62 * colour, zorder=1)
    _add_circles(axes, seen, 0.90 * radius, colour, zorder=1.1)
    axes.add_collection(PolyCollection(webs, facecolors=colour[inside[:, 0]], zorder=2))


def _draw_bonds(axes: Axes, ends: np.ndarray) -> None:
    """Stitches (b, 2, 2) along the middle of the lines between the elements."""
    middle = ends.mean(axis=1, keepdims=True)
    stitches = middle + 0.4 * (ends - middle)
    style = {"colors": BOND_COLOUR, "linewidths": 1.2, "capstyle": "round"}
    axes.add_collection(LineCollection(stitches, **style, zorder=3))


def _draw_spheres(
    axes: Axes, specimen: Specimen, colour: np.ndarray, view: np.ndarray
) -> np.ndarray:
    """Spheres from back to front, each a stack of discs that lighten towards the light.

    Returns the projected centres (n, 2) [mm].
    """
    (sin_e, sin_a), (cos_e, cos_a) = np.sin(view), np.cos(view)
    right = np.array([-sin_a, cos_a, 0.0])
    towards = np.array([cos_e * cos_a, cos_e * sin_a, sin_e])
    seen = 1e3 * specimen.position @ np.column_stack([right, np.cross(towards, right)])
    depth = specimen.position @ towards
    order = np.argsort(depth, kind="stable")
    nearness = (depth - depth.min()) / max(np.ptp(depth), specimen.radius.max())
    base = colour * (0.45 + 0.55 * nearness[:, None])

    share = np.sqrt(1 - np.linspace(0, 1, 12, endpoint=False) ** 2)
    lightness = 1.15 - 0.85 * share
    radius = 1e3 * specimen.radius[order, None]
    centre = seen[order, None, :] + (radius * (1 - share))[:, :, None] * LIGHT
    shade = np.clip(base[order, None, :] * (0.35 + 0.85 * lightness)[:, None], 0, 1)
    _add_circles(
        axes, centre.reshape(-1, 2), (radius * share).ravel(), shade.reshape(-1, 3), zorder=1
    )
    return seen


def _add_circles(
    axes: Axes, centre: np.ndarray, radius: np.ndarray, colour: np.ndarray, zorder: float
) -> None:
    width = 2 * radius
    circles = EllipseCollection(
        width,
        width,
        np.zeros(len(width)),
        units="xy",
        offsets=centre,
        offset_transform=axes.transData,
        facecolors=colour,
        linewidths=0,
        zorder=zorder,
    )
    axes.add_collection(circles)
