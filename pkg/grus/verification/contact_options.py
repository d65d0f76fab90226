"""Options of the contact: Hertz-Mindlin and rolling resistance against YADE's laws, yielding against its formula."""

from collections.abc import Iterator
from math import atan

from yade.wrapper import (
    BondLedger,
    BondMat,
    CohFrictMat,
    FrictMat,
    Ig2_Sphere_Sphere_ScGeom,
    Ig2_Sphere_Sphere_ScGeom6D,
    Ip2_BondMat_BondMat_BondPhys,
    Ip2_CohFrictMat_CohFrictMat_CohFrictPhys,
    Ip2_FrictMat_FrictMat_MindlinPhys,
    Law2_ScGeom6D_CohFrictPhys_CohesionMoment,
    Law2_ScGeom_BondPhys_Bonded,
    Law2_ScGeom_MindlinPhys_Mindlin,
)

from grus.verification.elastic import load
from grus.verification.formulas import Motion
from grus.verification.law import DENSITY, Law
from grus.verification.pair import PairScene
from grus.verification.row import Row, compare

PART = "other laws"
RADII = (1.0e-3, 1.6e-3)
STEPS = 100
SOLID = {"young": 70e9, "poisson": 0.25, "density": DENSITY, "frictionAngle": atan(0.4)}
ALPHA, ETA, RATIO = 0.7, 0.15, 3.0
PRESSED = Motion(overlap=2e-6)
SHEARED, SLID = Motion(slip=1e-7), Motion(overlap=-8e-7, slip=3e-6)
HERTZ_PATHS = {
    "pressed": [PRESSED],
    "pressed and sheared": [PRESSED, SHEARED],
    "pressed, sheared, let go a little while sliding": [PRESSED, SHEARED, SLID],
}
ROLLED = Motion(bending=2e-5, axis=(0.6, 0.8))
ROLLING_PATHS = {
    "pressed and rolled": [PRESSED, ROLLED],
    "rolled beyond the limit and back": [PRESSED, ROLLED.times(100), ROLLED.times(-3)],
}
NONE = ("", "")  # there is no strength


def contact_options_rows() -> Iterator[Row]:
    """Force and moment after some motions."""
    for name, path in HERTZ_PATHS.items():
        yield compare(
            PART,
            f"Mindlin, pair: {name}",
            "force and moment",
            "N",
            _load(_mindlin(), path),
            _load(_grus(contactLaw="hertz"), path),
            1e-6,
            "YADE's Law2_ScGeom_MindlinPhys_Mindlin with the same modulus and Poisson's ratio.",
        )
    for name, path in ROLLING_PATHS.items():
        yield compare(
            PART,
            f"CohFrict with rolling friction, pair: {name}",
            "force and moment",
            "N",
            _load(_cohfrict(), path),
            _load(_grus(rollingStiffness=ALPHA, rollingFriction=ETA), path),
            1e-6,
            "YADE's Law2_ScGeom6D_CohFrictPhys_CohesionMoment, not bonded, in increments; alphaKr and etaRoll are rolling "
            "stiffness and friction.",
        )
    yield from _yielding_rows()


def _grus(**options: float | str) -> Law:
    ledger = BondLedger()
    return Law(
        BondMat(**SOLID, **options),
        Ig2_Sphere_Sphere_ScGeom(),
        Ip2_BondMat_BondMat_BondPhys(),
        Law2_ScGeom_BondPhys_Bonded(ledger=ledger),
        NONE,
        [ledger],
    )


def _mindlin() -> Law:
    return Law(
        FrictMat(**SOLID),
        Ig2_Sphere_Sphere_ScGeom(),
        Ip2_FrictMat_FrictMat_MindlinPhys(),
        Law2_ScGeom_MindlinPhys_Mindlin(),
        NONE,
    )


def _cohfrict() -> Law:
    return Law(
        CohFrictMat(
            **SOLID,
            isCohesive=False,
            momentRotationLaw=True,
            alphaKr=ALPHA,
            alphaKtw=0,
            etaRoll=ETA,
            etaTwist=0,
        ),
        Ig2_Sphere_Sphere_ScGeom6D(),
        Ip2_CohFrictMat_CohFrictMat_CohFrictPhys(),
        Law2_ScGeom6D_CohFrictPhys_CohesionMoment(
            useIncrementalForm=True, always_use_moment_law=True
        ),
        NONE,
    )


def _load(law: Law, path: list[Motion]):
    scene = PairScene(law, RADII)
    for motion in path:
        scene.drive(motion, STEPS)
    return load(scene)


def _yielding_rows() -> Iterator[Row]:
    """Force and lost energy of a contact that is pressed and let go again."""
    law = _grus(unloadingRatio=RATIO)
    scene = PairScene(law, RADII)
    top, back = PRESSED.overlap, 5e-7
    scene.drive(PRESSED, STEPS)
    kn = scene.interaction.phys.kn
    scene.drive(Motion(overlap=-back), STEPS)
    case = f"yielding contact, pair: pressed by {top:g} m, let go by {back:g} m"
    note = f"Walton & Braun (1986) with a ratio of {RATIO:g}."
    found = scene.interaction.phys.normalForce.norm()
    yield compare("formulas", case, "force", "N", kn * (top - RATIO * back), found, 1e-9, note)
    lost = kn * top**2 / 2 * (1 - 1 / RATIO)
    yield compare(
        "formulas", case, "energy lost", "J", lost, law.engines[0].slidingWork, 1e-9, note
    )
