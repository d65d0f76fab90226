"""Regular packings of equal elements that touch without overlap."""

from itertools import product

import numpy as np

from grus.specimen.require import require, require_positive
from grus.specimen.rotation import plane_rotation, random_rotation

# Rows are cell vectors, and sites within the cell are in fractions of them; in element radii.
TRIANGULAR_CELL = np.array([[2.0, 0.0], [1.0, np.sqrt(3.0)]])
TRIANGULAR_SITES = np.zeros((1, 2))
HEXAGONAL_CELL = np.array(
    [[2.0, 0.0, 0.0], [1.0, np.sqrt(3.0), 0.0], [0.0, 0.0, 4.0 * np.sqrt(2.0 / 3.0)]]
)
HEXAGONAL_SITES = np.array([[0.0, 0.0, 0.0], [1.0 / 3.0, 1.0 / 3.0, 0.5]])


def lattice(
    dimension: int, radius: float, extent: float, generator: np.random.Generator
) -> np.ndarray:
    """Centres (n, 3) [m] of a close packing within `extent` [m] of the origin.

    dimension 2: triangular lattice in z = 0, turned by an angle uniform in [0, pi/3).
    dimension 3: hexagonal close packing (layers ABAB), turned by a uniform random rotation.
    radius: of the elements [m]; neighbours are two radii apart.
    The lattice is moved by a vector uniform over its unit cell. It may be empty when `extent` is
    small. Raises GrusError for another dimension or lengths that are not positive.
    """
    require(dimension in (2, 3), "dimension", dimension, "2 or 3")
    require_positive("element_radius", radius, "m")
    require_positive("extent", extent, "m")
    plane = dimension == 2
    cell = radius * (TRIANGULAR_CELL if plane else HEXAGONAL_CELL)
    sites = TRIANGULAR_SITES if plane else HEXAGONAL_SITES
    turn = plane_rotation(generator.random() * np.pi / 3) if plane else random_rotation(generator)
    offset = generator.random(dimension)

    # Along a cell vector, `extent` spans at most this many cells; two more hold sites and offset.
    span = np.ceil(extent * np.linalg.norm(np.linalg.inv(cell), axis=0)).astype(int) + 2
    cells = np.array(list(product(*(range(-s, s + 1) for s in span))), dtype=float)
    fraction = (cells[:, None, :] + sites[None, :, :] + offset).reshape(-1, dimension)
    position = np.zeros((len(fraction), 3))
    position[:, :dimension] = fraction @ cell
    position = position[np.linalg.norm(position, axis=1) <= extent]
    return position @ turn.T
