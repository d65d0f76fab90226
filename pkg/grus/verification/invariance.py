"""What must not change a bonded pair: the order of its bodies, and motion as one rigid body."""

from collections.abc import Iterator
from math import pi, sin

import numpy as np
from scipy.spatial.transform import Rotation

from grus.verification.elastic import PART, load
from grus.verification.formulas import BondedPair, Motion
from grus.verification.laws import grus_law
from grus.verification.pair import PairScene
from grus.verification.row import Row, compare

STEPS = 1000
_LOADED = Motion(-1e-6, 2e-6, 1e-3, 1e-3, (0.6, 0.8))
_PAIR = BondedPair("parallel", kn=0, ks=0)


def invariance_rows() -> Iterator[Row]:
    """Swapped bodies; rigid rotation of a pair without and with load."""
    yield from _swapped()
    yield _turned_without_load()
    yield _turned_under_load("across")
    yield _turned_under_load("along")


def _swapped() -> Iterator[Row]:
    for kind in ("contact", "parallel"):
        pair = BondedPair(kind)
        loads = []
        for swapped in (False, True):
            scene = PairScene(grus_law(pair), pair.radii, swapped=swapped)
            scene.drive(_LOADED, STEPS // 10)
            loads.append(load(scene))
        yield compare(
            PART,
            f"{kind} bond, spheres: second body put in first",
            "force and moment",
            "N",
            *loads,
            1e-10,
            "The same pair, motion and places; only the ids in YADE are swapped.",
        )


def _turned_without_load() -> Row:
    """A full turn about an axis across the normal."""
    scene = PairScene(grus_law(_PAIR), _PAIR.radii)
    scene.turn(2 * pi * scene.binormal, STEPS)
    angle = 2 * pi / STEPS
    slip = sum(_PAIR.radii) * STEPS * (angle - sin(angle))
    return compare(
        PART,
        f"parallel bond, spheres: rigid full turn in {STEPS} steps",
        "force on a body",
        "N",
        _PAIR.bond_ks * slip,
        np.linalg.norm(scene.forces()[0]),
        1e-3,
        "YADE's contact geometry takes the chord of a step for the arc: slip (R1 + R2)(a - sin a) in a step of angle "
        "a. It falls with the square of the step: at 1e-3 a step it is below 2e-7 of the arc.",
    )


def _turned_under_load(direction: str) -> Row:
    """A quarter turn of a loaded pair, in steps so small that the slip of `_turned_without_load` vanishes."""
    scene = PairScene(grus_law(_PAIR), _PAIR.radii)
    scene.drive(_LOADED, 50)
    before = load(scene)
    axis = scene.normal if direction == "along" else scene.binormal
    steps = 20 * STEPS if direction == "across" else STEPS
    scene.turn(pi / 2 * axis, steps)
    turned = before @ Rotation.from_rotvec(pi / 2 * axis).as_matrix().T
    return compare(
        PART,
        f"parallel bond, spheres: loaded pair turned by 90 degrees {direction} the normal",
        "force and moment",
        "N",
        turned,
        load(scene),
        1e-5 if direction == "across" else 1e-10,
        "The load turns with the pair." + (f" In {steps} steps." if direction == "across" else ""),
    )
