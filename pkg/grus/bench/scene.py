"""The block of bonded elements in YADE, the same for every law."""

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

from grus.bench.block import (
    DENSITY,
    RADIUS,
    SKIN,
    STIFFNESS,
    UNBREAKABLE,
    block,
    time_step,
    velocities,
)
from grus.bench.cases import SUBSTEPS, Case
from grus.host.differences import leapfrog, set_moment_bounds
from grus.scene import InteractionEngines, bond, insert

REACH = 1.01  # of the sum of the radii, within which elements are bonded


def build(case: Case, loop: str) -> tuple[int, int]:
    """Fills the empty scene and sets `O.engines`; returns the numbers of elements and of bonds."""
    specimen = block(case)
    thickness = 1.0 if case.dimension == 2 else 0.0
    grain = BondMat(
        density=DENSITY,
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
    O.dt = time_step(case.dimension)
    if loop in ("law2", "grainloop"):
        engines = InteractionEngines()
        O.engines = engines.list + [leapfrog(damping=0.2)]
        bonds = bond(specimen, engines)
        if loop == "grainloop":
            O.engines = [GrainLoop(damping=0.2, ledger=BondLedger(), substeps=SUBSTEPS, skin=SKIN)]
    else:
        bonds = _yades(*RIVALS[loop])
    _shake(case.dimension)
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
        density=DENSITY,
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
        density=DENSITY,
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


def _shake(dimension: int) -> None:
    """Gives the bodies their velocities."""
    bodies = [body for body in O.bodies if not body.isClumpMember]
    for body, velocity in zip(bodies, velocities(len(bodies), dimension).tolist()):
        body.state.vel = velocity
