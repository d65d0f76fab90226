"""Load at which a bond breaks, its mode and the energy it releases, against the formulas."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import nan

import numpy as np

from grus.verification.elastic import PART, THICKNESS
from grus.verification.formulas import BondedPair, Motion
from grus.verification.laws import grus_law
from grus.verification.pair import PairScene
from grus.verification.row import Row, compare, worst

BRACKET = 1e-8  # the bond must hold at this share below the strength and break at this share above
STEPS = 100
MODES = {1: "tension", 2: "shear"}

_TENSION, _SHEAR = Motion(overlap=-1e-7), Motion(slip=1e-7)
_BENDING, _TWIST = Motion(bending=1e-4, axis=(0.6, 0.8)), Motion(twist=1e-4)
_ALL = Motion(-1e-7, 1e-7, 1e-4, 1e-4, (0.6, 0.8))
_PRESSED, _PULLED = Motion(overlap=2e-7, slip=1e-6), Motion(overlap=-5e-8, slip=2e-7)

_CONTACT = BondedPair("contact", tensile=2.0, shear=3.0)
_SPHERES = BondedPair("parallel", tensile=1e6, shear=1.5e6)
_DISCS = replace(_SPHERES, thickness=THICKNESS)
_IN_PLANE = Motion(-1e-7, 1e-7, 1e-4)
_MOHR = 0.6  # tan(phi) where the shear strength grows with pressure

CASES: list[tuple[str, BondedPair, Motion]] = [
    ("contact bond: tension", _CONTACT, _TENSION),
    ("contact bond: shear", _CONTACT, _SHEAR),
    ("contact bond: tension and shear", _CONTACT, Motion(-1e-7, 1e-7)),
    ("contact bond: shear under pressure, tan phi 0.6", replace(_CONTACT, tan_phi=_MOHR), _PRESSED),
    ("contact bond: shear under tension, tan phi 0.6", replace(_CONTACT, tan_phi=_MOHR), _PULLED),
    ("parallel bond, spheres: tension", _SPHERES, _TENSION),
    ("parallel bond, spheres: shear", _SPHERES, _SHEAR),
    *(
        (f"parallel bond, spheres: {name}, beta {beta:g}", replace(_SPHERES, beta=beta), motion)
        for name, motion in (("bending", _BENDING), ("twist", _TWIST))
        for beta in (0.5, 1.0)
    ),
    *(
        (f"parallel bond, spheres: all at once, beta {beta:g}", replace(_SPHERES, beta=beta), _ALL)
        for beta in (0.0, 0.5, 1.0)
    ),
    (
        "parallel bond, spheres: shear under pressure, tan phi 0.6",
        replace(_SPHERES, tan_phi=_MOHR),
        _PRESSED,
    ),
    (
        "parallel bond, spheres: shear under tension, tan phi 0.6",
        replace(_SPHERES, tan_phi=_MOHR),
        _PULLED,
    ),
    *(
        (
            f"parallel bond, discs: tension, shear, bending, beta {beta:g}",
            replace(_DISCS, beta=beta),
            _IN_PLANE,
        )
        for beta in (0.0, 0.5, 1.0)
    ),
]


@dataclass(frozen=True)
class Break:
    """What a scene did on the way through its breaking point."""

    held: bool  # just below the strength
    broke: bool  # just above it
    mode: int
    stress: float  # that met its limit, just below
    released: float  # [J], booked by the ledger
    force: float  # left after the break [N]


def breaking_rows() -> Iterator[Row]:
    """One row a case for the stress at break; one for all of released energy and of what is left."""
    released, left = [], []
    for case, pair, motion in CASES:
        factor, mode = pair.load_to_break(motion)
        at = motion.times(factor)
        found = _break(pair, at, mode)
        good = found.held and found.broke and found.mode == mode
        limit = pair.tensile if mode == 1 else pair.shear + pair.stresses(at)[2] * pair.tan_phi
        yield compare(
            PART,
            case,
            "strength",
            "Pa" if pair.parallel else "N",
            limit,
            found.stress if good else nan,
            2 * BRACKET,
            f"Held at (1 - 1e-8) of the load and broke in {MODES[mode]} at (1 + 1e-8) of it; eqs 15-17 of Potyondy & "
            "Cundall (2004), moments weighed by beta, shear strength c + sigma tan(phi).",
        )
        released.append(
            compare(
                PART,
                f"all breaks above; worst: {case}",
                "released energy",
                "J",
                pair.released(at),
                found.released,
                1e-6,
                "What the bond had stored, as booked by BondLedger; of a contact bond without what the frictional "
                "contact keeps. The bracket of the load is the deviation.",
            )
        )
        left.append(
            compare(
                PART,
                f"all breaks above; worst: {case}",
                "force left",
                "N",
                pair.left_after_break(at),
                found.force,
                1e-6,
                "Contact without tension and its friction, in the step of the break.",
            )
        )
    yield worst(released)
    yield worst(left)
    yield from _without_moments()


def _break(pair: BondedPair, at: Motion, mode: int) -> Break:
    scene = PairScene(grus_law(pair), pair.radii, plane=pair.thickness > 0)
    scene.drive(at.times(1 - BRACKET), STEPS)
    held = scene.holds
    phys = scene.interaction.phys
    stress = phys.tension() if mode == 1 else phys.shear()
    scene.drive(at.times(2 * BRACKET), 1)
    ledger = scene.law.engines[0]
    return Break(
        held=held,
        broke=not scene.holds and ledger.breaks == 1,
        mode=ledger.brokenMode[0] if ledger.brokenMode else 0,
        stress=stress,
        released=ledger.releasedEnergy,
        force=float(np.linalg.norm(scene.forces()[1])),
    )


def _without_moments() -> Iterator[Row]:
    """With beta = 0 moments break nothing."""
    for name, motion in (("bending", _BENDING), ("twist", _TWIST)):
        full, _ = _SPHERES.load_to_break(motion)
        pair = replace(_SPHERES, beta=0.0)
        scene = PairScene(grus_law(pair), pair.radii)
        scene.drive(motion.times(3 * full), STEPS)
        yield compare(
            PART,
            f"parallel bond, spheres: {name}, beta 0",
            "bonds that hold",
            "1",
            1,
            int(scene.holds),
            0,
            "At 3 times the moment that breaks it with beta = 1.",
        )
