"""One grain: an outline filled with elements, gathered into clumps."""

from dataclasses import asdict

import numpy as np

from grus.specimen.lattice import lattice
from grus.specimen.missing import remaining
from grus.specimen.outline import Outline
from grus.specimen.require import require, require_positive
from grus.specimen.rotation import plane_rotation, random_rotation
from grus.specimen.rounding import on_grid
from grus.specimen.specimen import Specimen
from grus.specimen.stamp import Stamp
from grus.specimen.stream import Purpose, stream
from grus.specimen.touching import largest_part


def agglomerate(
    outline: Outline,
    element_radius: float,
    *,
    stamp: Stamp | None = None,
    missing: float = 0.0,
    seed: int,
    grain: int = 0,
    thickness: float = 1.0,
    random_orientation: bool = True,
) -> Specimen:
    """A specimen of one grain, with the centroid of its outline at the origin.

    outline: filled by a close packing of random orientation and offset; an element belongs to the
        grain when it lies inside as a whole.
    element_radius [m]: of all elements.
    stamp: how elements are gathered into clumps; None leaves each a clump of its own.
    missing: fraction of the elements taken out at random, in [0, 1), before stamping. Of what is
        left, only the largest set connected by touching is kept: no loose element lies in a grain.
        (So a thin neck of the outline that no element fits into also costs the smaller side.)
    seed, grain: fix every random choice; grains of one seed are independent of each other and of
        how many there are.
    thickness [m]: of a plane grain.
    random_orientation: turn the filled outline by a random rotation (in the plane by an angle
        uniform in [0, 2 pi)); False keeps the outline as it was given.
    Raises GrusError when an argument is out of bounds or no element fits into the outline.
    """
    require_positive("element_radius", element_radius, "m")
    most = outline.bounding_radius
    require(element_radius < most, "element_radius", element_radius, f"below {most} m, the outline")
    position = lattice(
        outline.dimension,
        element_radius,
        most - element_radius,
        stream(seed, grain, Purpose.LATTICE),
    )
    position = position[outline.contains(position, element_radius)] if len(position) else position
    fits = f"small enough that an element fits into the outline ({outline.equivalent_diameter} m)"
    require(len(position) > 0, "element_radius", element_radius, fits)

    position = position[remaining(len(position), missing, stream(seed, grain, Purpose.MISSING))]
    position = position[largest_part(position, np.full(len(position), element_radius))]
    radius = np.full(len(position), element_radius)
    if stamp is None:
        clump = np.arange(len(radius))
    else:
        clump = stamp.press(position, radius, outline.box, stream(seed, grain, Purpose.STAMP))
    if random_orientation:
        position = position @ _orientation(outline.dimension, seed, grain).T

    return Specimen(
        dimension=outline.dimension,
        thickness=thickness,
        position=on_grid(position, element_radius),
        radius=radius,
        clump=clump,
        grain=np.zeros(len(radius)),
        grain_diameter=[outline.equivalent_diameter],
        meta={
            "maker": "agglomerate",
            "outline": outline.describe(),
            "element_radius": float(element_radius),
            "stamp": None if stamp is None else asdict(stamp),
            "missing": float(missing),
            "seed": int(seed),
            "grain": int(grain),
            "random_orientation": bool(random_orientation),
        },
    )


def _orientation(dimension: int, seed: int, grain: int) -> np.ndarray:
    generator = stream(seed, grain, Purpose.ORIENTATION)
    if dimension == 2:
        return plane_rotation(generator.random() * 2 * np.pi)
    return random_rotation(generator)
