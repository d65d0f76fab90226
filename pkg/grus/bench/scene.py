"""The same block of bonded elements for every loop."""

import math
from collections.abc import Callable

import numpy as np
from yade import O
from yade.wrapper import (
    Bo1_Sphere_Aabb,
    BondLedger,
    BondMat,
    CohFrictMat,
    ForceResetter,
    GrainLoop,
    Ig2_Sphere_Sphere_ScGeom,
    Ig2_Sphere_Sphere_ScGeom6D,
    InsertionSortCollider,
    InteractionLoop,
    Ip2_CohFrictMat_CohFrictMat_CohFrictPhys,
    Ip2_JCFpmMat_JCFpmMat_JCFpmPhys,
    JCFpmMat,
    JCFpmState,
    Law2_ScGeom6D_CohFrictPhys_CohesionMoment,
    Law2_ScGeom_JCFpmPhys_JointedCohesiveFrictionalPM,
    Material,
    State,
)

from grus.bench.cases import SUBSTEPS, Case
from grus.host.differences import leapfrog, set_moment_bounds
from grus.scene import InteractionEngines, bond, insert
from grus.specimen import Circle, Specimen, Sphere, Stamp, agglomerate

RADIUS = 1e-3  # of an element [m]
STIFFNESS = 1e8  # of contact and bond [N/m]
UNBREAKABLE = 1e15  # [Pa]
REACH = 1.01  # of the sum of the radii, within which elements are bonded


def block(case: Case) -> Specimen:
    """A disc or ball of elements in closest packing."""
    filled = math.pi / math.sqrt(12) if case.dimension == 2 else math.pi / math.sqrt(18)
    diameter = 2 * RADIUS * (case.elements / filled) ** (1 / case.dimension)
    outline = Circle(diameter) if case.dimension == 2 else Sphere(diameter)
    stamp = Stamp(mean=2.1 * RADIUS, deviation=0) if case.stamped else None
    return agglomerate(outline, element_radius=RADIUS, stamp=stamp, seed=1, grain=0)


def build(case: Case, loop: str) -> tuple[int, int]:
    """Fills the empty scene and sets `O.engines`; returns the numbers of elements and of bonds."""
    specimen = block(case)
    thickness = 1.0 if case.dimension == 2 else 0.0
    grain = BondMat(
        density=2500,
        kn=STIFFNESS,
        ks=STIFFNESS,
        frictionAngle=0.5,
        bond="parallel",
        bondKn=STIFFNESS,
        bondKs=STIFFNESS,
        tensileStrength=UNBREAKABLE,
        shearStrength=UNBREAKABLE,
        thickness=thickness,
    )
    insert(specimen, grain)
    O.dt = 0.1 * math.sqrt(2500 * RADIUS**2 * (1.0 if thickness else RADIUS) / STIFFNESS)
    if loop in ("law2", "grainloop"):
        engines = InteractionEngines()
        O.engines = engines.list + [leapfrog(damping=0.2)]
        bonds = bond(specimen, engines)
        if loop == "grainloop":
            O.engines = [GrainLoop(damping=0.2, ledger=BondLedger(), substeps=SUBSTEPS)]
    else:
        bonds = _yades(*RIVALS[loop])
    _shake()
    return specimen.element_count, bonds


def _yades(material: Callable[[], Material], contact: type, functors: Callable, tuned: bool) -> int:
    """YADE's own law instead of Grus's."""
    other = material()
    O.materials.append(other)
    for body in O.bodies:
        if not body.isClump:
            body.material = other
            if isinstance(other, JCFpmMat):
                body.state = _jcfpm_state(body.state)
    bounds, geometry = Bo1_Sphere_Aabb(), contact()
    ip2, law = functors(tuned)
    if isinstance(other, CohFrictMat):
        set_moment_bounds(other, ip2, False)
    collider = InsertionSortCollider([bounds])
    if tuned:
        collider.verletDist = 0.05 * RADIUS
        spread = [np.ptp([b.state.pos[axis] for b in O.bodies]) for axis in range(3)]
        collider.sortAxis = int(np.argmax(spread))
    newton = leapfrog(damping=0.2)
    O.engines = [ForceResetter(), collider, InteractionLoop([geometry], [ip2], [law]), newton]
    dt, O.dt = O.dt, 0
    bounds.aabbEnlargeFactor = geometry.interactionDetectionFactor = REACH
    O.step()
    bounds.aabbEnlargeFactor = geometry.interactionDetectionFactor = 1
    O.dt = dt
    return sum(i.isReal for i in O.interactions)


def _cohfrict(tuned: bool) -> tuple:
    return (
        Ip2_CohFrictMat_CohFrictMat_CohFrictPhys(setCohesionNow=True),
        Law2_ScGeom6D_CohFrictPhys_CohesionMoment(useIncrementalForm=tuned),
    )


def _jcfpm(tuned: bool) -> tuple:
    return (
        Ip2_JCFpmMat_JCFpmMat_JCFpmPhys(cohesiveTresholdIteration=1),
        Law2_ScGeom_JCFpmPhys_JointedCohesiveFrictionalPM(),
    )


def _cohfrict_material() -> CohFrictMat:
    return CohFrictMat(
        young=STIFFNESS / RADIUS,
        poisson=1,
        density=2500,
        isCohesive=True,
        momentRotationLaw=True,
        alphaKr=1,
        alphaKtw=1,
        normalCohesion=UNBREAKABLE,
        shearCohesion=UNBREAKABLE,
    )


def _jcfpm_material() -> JCFpmMat:
    return JCFpmMat(
        young=STIFFNESS / RADIUS,
        poisson=1,
        density=2500,
        tensileStrength=UNBREAKABLE,
        cohesion=UNBREAKABLE,
    )


def _jcfpm_state(state: State) -> JCFpmState:
    """The same body in the state that JCFpm asks for."""
    other = JCFpmState(mass=state.mass, inertia=state.inertia)
    other.pos, other.ori, other.blockedDOFs = state.pos, state.ori, state.blockedDOFs
    return other


RIVALS = {
    "cohfrict_moments": (_cohfrict_material, Ig2_Sphere_Sphere_ScGeom6D, _cohfrict, False),
    "cohfrict_moments_tuned": (_cohfrict_material, Ig2_Sphere_Sphere_ScGeom6D, _cohfrict, True),
    "jcfpm": (_jcfpm_material, Ig2_Sphere_Sphere_ScGeom, _jcfpm, False),
}


def _shake() -> None:
    """Small velocities, so that every bond has something to do."""
    random = np.random.default_rng(1)
    for body in O.bodies:
        if not body.isClumpMember:
            velocity = 1e-3 * (random.random(3) - 0.5)
            body.state.vel = [
                0 if axis in body.state.blockedDOFs else float(v)
                for axis, v in zip("xyz", velocity)
            ]
