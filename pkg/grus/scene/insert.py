"""Puts a specimen into YADE."""

import numpy as np
from yade import O
from yade.minieigenHP import Matrix3, Vector3
from yade.wrapper import BondMat

from grus import _engines
from grus.specimen import Specimen, clump_properties


def insert(specimen: Specimen, material: BondMat, first_grain: int = 0) -> list[int]:
    """Adds elements and clumps to the current scene; returns the body ids of the elements, in their order.

    Clumps get the exact mass and inertia of their discs or spheres. Grain i of the specimen becomes grain
    `first_grain` + i of the scene (`BondState.grain`), which fixes the random strengths of its bonds.
    """
    O.materials.append(material)
    properties = clump_properties(specimen, material.density)
    first, second = specimen.bonds().T
    return list(
        _engines.insertSpecimen(
            position=[Vector3(*row) for row in specimen.position.tolist()],
            radius=specimen.radius.tolist(),
            clump=specimen.clump.tolist(),
            grain=(specimen.grain + first_grain).tolist(),
            element=_number_in_grain(specimen.grain).tolist(),
            grainDiameter=specimen.grain_diameter[specimen.grain].tolist(),
            clumpCentre=[Vector3(*row) for row in properties.centre.tolist()],
            clumpMass=properties.mass.tolist(),
            clumpInertia=[
                Matrix3(*tensor) for tensor in properties.inertia.reshape(-1, 9).tolist()
            ],
            first=first.tolist(),
            second=second.tolist(),
            material=material,
        )
    )


def _number_in_grain(grain: np.ndarray) -> np.ndarray:
    """Number (n,) of each element among those of its grain, in order of appearance."""
    number = np.empty(len(grain), dtype=np.int64)
    for one in np.unique(grain):
        members = np.flatnonzero(grain == one)
        number[members] = np.arange(len(members))
    return number
