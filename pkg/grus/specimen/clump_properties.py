"""Mass, centre of mass and inertia of clumps."""

from typing import NamedTuple

import numpy as np

from grus.specimen.require import require_positive
from grus.specimen.specimen import Specimen

# Inertia of an element about its own centre, in m r^2: a thin disc with z as its axis, a sphere.
OWN_INERTIA = {2: np.diag([1 / 4, 1 / 4, 1 / 2]), 3: np.diag([2 / 5, 2 / 5, 2 / 5])}


class ClumpProperties(NamedTuple):
    """centre (m, 3) [m]; mass (m,) [kg]; inertia (m, 3, 3) about the centre [kg m2]."""

    centre: np.ndarray
    mass: np.ndarray
    inertia: np.ndarray


def element_volume(specimen: Specimen) -> np.ndarray:
    """Volume (n,) [m3]: pi r^2 t of the discs of a plane specimen, 4/3 pi r^3 of spheres."""
    if specimen.dimension == 2:
        return np.pi * specimen.radius**2 * specimen.thickness
    # A product, not a power, of which the last digit changed from one version of numpy to the next.
    return 4 / 3 * np.pi * (specimen.radius * specimen.radius * specimen.radius)


def clump_volume(specimen: Specimen) -> np.ndarray:
    """Volume (m,) of the elements of each clump [m3]."""
    return np.bincount(specimen.clump, weights=element_volume(specimen))


def clump_properties(specimen: Specimen, density: float) -> ClumpProperties:
    """Rigid-body properties of the clumps, for elements of the given density [kg/m3].

    Sums over the elements, exact because elements do not overlap: m r^2/2 (disc) or 2/5 m r^2
    (sphere) plus Steiner's m (|d|^2 1 - d d). Discs count as thin: their two in-plane axes have
    m r^2/4, so that Ixx + Iyy = Izz; in plane motion these two play no part.
    Raises GrusError when the density is not positive.
    """
    require_positive("density", density, "kg/m3")
    clump, count = specimen.clump, specimen.clump_count
    element_mass = density * element_volume(specimen)
    mass = np.bincount(clump, weights=element_mass)
    centre = np.zeros((count, 3))
    np.add.at(centre, clump, element_mass[:, None] * specimen.position)
    centre /= mass[:, None]

    arm = specimen.position - centre[clump]
    steiner = (arm**2).sum(axis=1)[:, None, None] * np.eye(3) - arm[:, :, None] * arm[:, None, :]
    own = (specimen.radius**2)[:, None, None] * OWN_INERTIA[specimen.dimension]
    inertia = np.zeros((count, 3, 3))
    np.add.at(inertia, clump, element_mass[:, None, None] * (own + steiner))
    return ClumpProperties(centre, mass, inertia)
