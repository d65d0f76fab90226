"""The box around a specimen."""

from collections.abc import Sequence

import numpy as np
from yade import O, utils
from yade.wrapper import BondMat


def add_walls(lower: Sequence[float], upper: Sequence[float], material: BondMat) -> list[list[int]]:
    """Puts the two walls across each axis into the current scene; returns their ids, lower first, by axis."""
    O.materials.append(material)
    ids = []
    for axis, ends in enumerate(zip(lower, upper)):
        walls = [utils.wall(float(end), axis=axis, material=material) for end in ends]
        for wall in walls:
            # Otherwise NewtonIntegrator books damping of their prescribed motion as lost energy.
            wall.state.isDamped = False
        ids.append(list(O.bodies.append(walls)))
    return ids


def platen_ends(walls: list[list[int]]) -> tuple[float, float]:
    """Positions of the bottom and the top platen now [m]."""
    axis = len(walls) - 1
    bottom, top = (float(O.bodies[wall].state.pos[axis]) for wall in walls[axis])
    return bottom, top


def wall_box(walls: list[list[int]]) -> tuple[np.ndarray, np.ndarray]:
    """Lower and upper corner (dimension,) of the box now [m]."""
    corners = [[O.bodies[w].state.pos[axis] for w in pair] for axis, pair in enumerate(walls)]
    return tuple(np.array(corners, dtype=float).T)
