"""Forces, moments and energy of a bonded pair that moves by a given amount, against the formulas."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from grus.verification.formulas import BondedPair, Motion
from grus.verification.laws import grus_law
from grus.verification.pair import PairScene
from grus.verification.row import Row, compare, worst

PART = "formulas"
STEPS = 50
THICKNESS = 0.01  # of the discs [m]
WAYS = {"total": 1.0, "area": 3.0e5, "modulus": 1.5e3}  # and the size of their numbers
MOTIONS = {
    "tension": Motion(overlap=-1e-6),
    "shear": Motion(slip=2e-6),
    "bending": Motion(bending=1e-3),
    "twist": Motion(twist=1e-3),
    "tension, shear, bending, twist": Motion(-1e-6, 2e-6, 1e-3, 2e-3),
    "pressure, shear, bending, twist": Motion(1e-6, 2e-7, 1e-3, 2e-3),
}
LOAD_NOTE = (
    "Length of the forces on both bodies and their moments over R1, Potyondy & Cundall (2004) eqs 11-14; "
    "spins make the slip, so the normal stays and the formula is exact."
)


def elastic_rows() -> Iterator[Row]:
    """Two rows a motion, load and energy; of a parallel bond the worst of the three ways to give its stiffness."""
    for kind in ("contact", "parallel"):
        for thickness in (0.0, THICKNESS):
            for name, motion in _motions(kind, thickness > 0):
                ways = WAYS if kind == "parallel" else {"total": 1.0}
                pairs = [
                    BondedPair(kind, thickness, way=way, bond_kn=2e6 * size, bond_ks=1.5e6 * size)
                    for way, size in ways.items()
                ]
                case = f"{kind} bond, {'discs' if thickness else 'spheres'}: {name}"
                loads, energies = zip(*(_loaded(case, pair, motion) for pair in pairs))
                yield worst(loads)
                yield worst(energies)
    yield _shear_by_translation()


def _motions(kind: str, plane: bool) -> Iterator[tuple[str, Motion]]:
    for name, motion in MOTIONS.items():
        if kind == "contact" and name in ("bending", "twist"):
            continue  # which alone give no load; below they must add none
        if plane:
            if name == "twist":
                continue
            yield name.replace(", twist", ""), replace(motion, twist=0.0)
        else:
            yield name, replace(motion, axis=(0.6, 0.8))


def _loaded(case: str, pair: BondedPair, motion: Motion) -> tuple[Row, Row]:
    scene = PairScene(grus_law(pair), pair.radii, plane=pair.thickness > 0)
    scene.drive(motion, STEPS)
    way = f" Stiffness given as '{pair.way}', the worst of the three ways." if pair.parallel else ""
    return (
        compare(
            PART,
            case,
            "force and moment",
            "N",
            expected_load(scene, pair, motion),
            load(scene),
            1e-10,
            LOAD_NOTE + way,
        ),
        compare(
            PART,
            case,
            "elastic energy",
            "J",
            pair.energy(motion),
            scene.interaction.phys.elasticEnergy(),
            1e-10,
            "Half of load times motion, contact and bond." + way,
        ),
    )


def load(scene: PairScene) -> np.ndarray:
    """Forces and moments over R1 on both bodies (4, 3) [N]."""
    return np.concatenate([scene.forces(), scene.torques() / scene.radii[0]])


def expected_load(scene: PairScene, pair: BondedPair, m: Motion) -> np.ndarray:
    """What `load` should give: forces act at the middle of the overlap, moments of the bond are added."""
    (contact_normal, contact_shear), (normal, shear, bending, twist) = (
        pair.contact_load(m),
        pair.bond_load(m),
    )
    force = (contact_normal + normal) * scene.normal + (contact_shear + shear) * scene.across
    moment = bending * (m.axis[0] * scene.across + m.axis[1] * scene.binormal)
    moment = moment + twist * scene.normal
    arm1, arm2 = scene.radii - m.overlap / 2
    torques = [
        -moment - arm1 * np.cross(scene.normal, force),
        moment - arm2 * np.cross(scene.normal, force),
    ]
    return np.concatenate([[-force, force], np.array(torques) / scene.radii[0]])


def _shear_by_translation() -> Row:
    """Second element moved across the normal without spin, so that the normal turns a little."""
    pair = BondedPair("parallel")
    scene = PairScene(grus_law(pair), pair.radii)
    slip = 1e-7 * sum(pair.radii)
    scene.translate(slip * scene.across)
    return compare(
        PART,
        "parallel bond, spheres: shear by translation",
        "force and moment",
        "N",
        expected_load(scene, pair, Motion(slip=slip)),
        load(scene),
        1e-6,
        "One step of 1e-7 (R1 + R2); the normal turns by 1e-7, and with it the force: that is the deviation.",
    )
