"""Moments of YADE's CohFrict against those of the parallel bond."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from grus.host.differences import MOMENT_BOUNDS
from grus.verification.elastic import load
from grus.verification.formulas import BondedPair, Motion
from grus.verification.law import Law
from grus.verification.laws import cohfrict_law, grus_law
from grus.verification.other_laws import BRACKET, PART, RADIUS
from grus.verification.pair import PairScene
from grus.verification.row import Row, compare

STEPS = 100
BOND = BondedPair("parallel", radii=(RADIUS, RADIUS), kn=0, ks=0, tensile=1e6, shear=1e6)
"""A parallel bond without a contact beside it: CohFrict has one spring in each direction, not two."""
ENDLESS = replace(BOND, tensile=np.inf, shear=np.inf)
MOTIONS = {
    "tension and shear": Motion(-1e-7, 2e-7),
    "bending": Motion(bending=1e-4, axis=(0.6, 0.8)),
    "twist": Motion(twist=1e-4),
    "all at once": Motion(-1e-7, 2e-7, 1e-4, 1e-4, (0.6, 0.8)),
}
NOTE = (
    "CohFrict with its kn and ks equal to those of the bond section, alphaKr = kr / (R1 R2 ks) with kr = kn I/A, "
    "alphaKtw = ktw / (R1 R2 ks) with ktw = ks J/A; no contact beside the bond. CohFrict takes its "
    "angles from the orientations of both bodies, Grus adds up increments: when the bodies also slip, that is spin "
    "together, the two differ by the product of the angles."
)


def rotation_law_rows() -> Iterator[Row]:
    """Elastic loads that agree; then what CohFrict does not know."""
    for name, motion in MOTIONS.items():
        loads = []
        for law in (grus_law(ENDLESS), _converted(ENDLESS)):
            scene = PairScene(law, BOND.radii)
            scene.drive(motion, STEPS)
            loads.append(load(scene))
        yield compare(
            PART,
            f"CohFrict with moments, pair: {name}",
            "force and moment",
            "N",
            *loads,
            1e-5,
            NOTE,
        )
    yield _moment_at_break()
    if MOMENT_BOUNDS:
        yield _moment_bound("bending")
        yield _moment_bound("twist")
    yield _stiffness_ratio()


def _converted(pair: BondedPair, moment_bounds: bool = False) -> Law:
    """CohFrict with the stiffnesses of a parallel bond, and its strengths in pure tension and shear."""
    (area, inertia, polar), (kn, ks) = pair.section, pair.per_area
    contact = replace(
        pair,
        kind="contact",
        kn=2 * kn * area,
        ks=2 * ks * area,
        tensile=pair.tensile * area,
        shear=pair.shear * area,
    )
    unit = pair.radii[0] * pair.radii[1] * ks * area
    alphas = kn * inertia / unit, ks * polar / unit
    return cohfrict_law(contact, *alphas, moment_bounds)


def _moment_at_break() -> Row:
    """Bending until the parallel bond breaks, and ten times as far."""
    motion = MOTIONS["bending"]
    factor, _ = BOND.load_to_break(motion)
    moment = BOND.bond_load(motion.times(factor))[2]
    scene = PairScene(_converted(BOND), BOND.radii)
    scene.drive(motion.times(10 * factor), STEPS)
    got = float(np.linalg.norm(scene.torques()[1])) if scene.holds else 0.0
    return compare(
        PART,
        "CohFrict with moments, pair: bending to 10 times the break of the parallel bond",
        "moment held",
        "N m",
        moment,
        got,
        None,
        "The parallel bond breaks at M = sigma_c I / (beta Rb); CohFrict does not, its moment bounds being switched off "
        "(YADE 2023.02a has none).",
    )


def _moment_bound(name: str) -> Row:
    """Highest moment that CohFrict holds with its bounds switched on, against that of a bond of its radius."""
    pair, motion = replace(BOND, ratio=1), MOTIONS[name]
    factor, _ = pair.load_to_break(motion)
    held = [
        _moment_held(law, motion.times(factor))
        for law in (grus_law(pair), _converted(pair, moment_bounds=True))
    ]
    return compare(
        PART,
        f"CohFrict with moment bounds, pair: {name}",
        "moment at break",
        "N m",
        *held,
        1e-3,
        "Both hold at (1 - 1e-6) of the load and have lost the bond at (1 + 1e-6): with beta = 1 and Rb = R a parallel "
        "bond breaks at sigma_c pi R^3 / 4 in bending and tau_c pi R^3 / 2 in twist, CohFrict at Cn R^3 / 4 and Cs R^3 / 2.",
    )


def _moment_held(law: Law, at: Motion) -> float:
    """Moment at a share BRACKET below `at` [N m]; not a number if the bond does not break between there and above."""
    scene = PairScene(law, BOND.radii)
    scene.drive(at.times(1 - BRACKET), STEPS)
    held, moment = scene.holds, float(np.linalg.norm(scene.torques()[1]))
    scene.drive(at.times(2 * BRACKET), 1)
    return moment if held and not scene.holds else np.nan


def _stiffness_ratio() -> Row:
    """Normal force under pressure over that under tension, with a contact beside the bond."""
    pair = replace(ENDLESS, kn=4e6, ks=3e6)
    forces = []
    for overlap in (1e-7, -1e-7):
        scene = PairScene(grus_law(pair), pair.radii)
        scene.drive(Motion(overlap=overlap), STEPS)
        forces.append(float(np.linalg.norm(scene.forces()[1])))
    return compare(
        PART,
        "parallel bond with a contact beside it: pressure over tension",
        "stiffness ratio",
        "1",
        1,
        forces[0] / forces[1],
        None,
        "1 is CohFrict, whose one spring pulls as it pushes. The contact beside a parallel bond only pushes, so the "
        "ratio is (kn contact + kn bond) / kn bond.",
    )
