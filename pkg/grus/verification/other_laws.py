"""A bonded pair under YADE's CohFrict and JCFpm, against the contact bond of Grus."""

from collections.abc import Callable, Iterator
from math import nan

import numpy as np

from grus.verification.elastic import load
from grus.verification.formulas import BondedPair, Motion
from grus.verification.law import Law
from grus.verification.laws import cohfrict_law, grus_law, jcfpm_law
from grus.verification.pair import PairScene
from grus.verification.row import Row, compare

PART = "other laws"
BRACKET = 1e-6
STEPS = 100
RADIUS = 1e-3
PAIR = BondedPair(
    "contact", radii=(RADIUS, RADIUS), tensile=2.0, shear=3.0, tan_phi=0.5, friction=0.5
)
MOTIONS = {
    "tension": Motion(overlap=-1e-7),
    "shear": Motion(slip=1e-7),
    "shear under pressure": Motion(overlap=2e-7, slip=1e-6),
    "shear under tension": Motion(overlap=-5e-8, slip=2e-7),
}
OTHERS: dict[str, Callable[[BondedPair], Law]] = {"CohFrict": cohfrict_law, "JCFpm": jcfpm_law}
CONVERSION = {
    "CohFrict": "E = kn/R, nu = ks/kn, cohesions = limits / R^2, one friction angle for bond and contact.",
    "JCFpm": "E = kn/R, nu = ks/kn, tensileStrength and cohesion = limits / (pi R^2), one friction angle.",
}


def other_laws_rows() -> Iterator[Row]:
    """Elastic load, break load and what is left after the break."""
    for name, law in OTHERS.items():
        yield _elastic(name, law)
        for motion_name, motion in MOTIONS.items():
            yield _break_load(name, law, motion_name, motion)
        yield _after_shear_break(name, law)
        yield _contact_again(name, law)


def _elastic(name: str, law: Callable[[BondedPair], Law]) -> Row:
    motion = Motion(-5e-7, 1e-6)
    loads = []
    for make in (grus_law, law):
        scene = PairScene(make(PAIR), PAIR.radii)
        scene.drive(motion, STEPS)
        loads.append(load(scene))
    return compare(
        PART,
        f"{name}, pair: tension and shear",
        "force and moment",
        "N",
        *loads,
        1e-9,
        f"Contact bond of Grus. {CONVERSION[name]}",
    )


def _break_load(
    name: str, law: Callable[[BondedPair], Law], motion_name: str, motion: Motion
) -> Row:
    """Highest load that the other law holds, against that of Grus."""
    factor, _ = PAIR.load_to_break(motion)
    held = [_held(make, motion.times(factor)) for make in (grus_law, law)]
    return compare(
        PART,
        f"{name}, pair: {motion_name}",
        "break load",
        "N",
        *held,
        1e-3,
        "Contact bond of Grus; both hold at (1 - 1e-6) of the load and have lost the bond at (1 + 1e-6). "
        + CONVERSION[name],
    )


def _held(make: Callable[[BondedPair], Law], at: Motion) -> float:
    """Force at a share BRACKET below `at` [N]; not a number if the bond does not break between there and above."""
    scene = PairScene(make(PAIR), PAIR.radii)
    scene.drive(at.times(1 - BRACKET), STEPS)
    held, force = scene.holds, float(np.linalg.norm(scene.forces()[1]))
    scene.drive(at.times(2 * BRACKET), 1)
    return force if held and not scene.holds else nan


def _after_shear_break(name: str, law: Callable[[BondedPair], Law]) -> Row:
    """Shear force in the very step of a shear break under pressure."""
    motion = MOTIONS["shear under pressure"]
    factor, _ = PAIR.load_to_break(motion)
    at = motion.times(factor * (1 + BRACKET))
    shears = []
    for make in (grus_law, law):
        scene = PairScene(make(PAIR), PAIR.radii)
        scene.drive(at, STEPS)
        shears.append(abs(scene.forces()[1] @ scene.across))
    informs = name == "JCFpm"
    return compare(
        PART,
        f"{name}, pair: shear under pressure",
        "shear force left, same step",
        "N",
        *shears,
        None if informs else 1e-3,
        (
            "JCFpm keeps the shear strength for the step of the break and falls to friction in the next."
            if informs
            else "Coulomb friction of the broken contact in both."
        ),
    )


def _contact_again(name: str, law: Callable[[BondedPair], Law]) -> Row:
    """Normal force of a pair that broke in tension and was pressed together again."""
    broken = Motion(overlap=-2 * PAIR.tensile / PAIR.kn).times(1.1)
    back = Motion(overlap=5e-7 - broken.overlap)
    forces = []
    for make in (grus_law, law):
        scene = PairScene(make(PAIR), PAIR.radii)
        scene.drive(broken, STEPS)
        scene.drive(back, STEPS)
        forces.append(float(np.linalg.norm(scene.forces()[1])))
    informs = name == "JCFpm"
    return compare(
        PART,
        f"{name}, pair: broken, then pressed by 5e-7 m",
        "force",
        "N",
        *forces,
        None if informs else 1e-3,
        (
            "JCFpm counts the overlap of a new contact from where it is first seen, so up to one step of motion is "
            f"lost, here {back.overlap / STEPS:.1e} m."
            if informs
            else "An ordinary contact without bond in both."
        ),
    )
