"""In what the supported YADEs differ for Python; for C++, see engines/yade/include/sdk/host_differences.hpp."""

from yade.wrapper import (
    CohFrictMat,
    Ip2_CohFrictMat_CohFrictMat_CohFrictPhys,
    MatchMaker,
    NewtonIntegrator,
)

_BOUNDS = ("rollingCohesion", "twistingCohesion")

MOMENT_BOUNDS = hasattr(Ip2_CohFrictMat_CohFrictMat_CohFrictPhys, _BOUNDS[0])
"""Whether bonds of CohFrict can break by moments: in YADE 2025.2.0 they do unless it is switched off, in 2023.02a never."""


def set_moment_bounds(
    material: CohFrictMat, physics: Ip2_CohFrictMat_CohFrictMat_CohFrictPhys, on: bool
) -> None:
    """Switches the breaking of CohFrict's bonds by moments on or off, whatever this YADE does by itself.

    On: a bond of cohesions Cn, Cs [Pa] and smaller radius r breaks at a bending moment Cn r^3 / 4 or a twisting moment
    Cs r^3 / 2 [N m], whatever the normal force. ValueError where this YADE has no such bounds.
    """
    if on and not MOMENT_BOUNDS:
        raise ValueError("bonds of CohFrict never break by moments in this YADE")
    # Share of the normal force, times the radius, that the bounds grow by; negative: the moment is elastic.
    material.etaRoll = material.etaTwist = 0 if on else -1
    if MOMENT_BOUNDS and not on:
        for bound in _BOUNDS:
            setattr(physics, bound, MatchMaker(algo="val", val=-1))


def leapfrog(**attributes: object) -> NewtonIntegrator:
    """NewtonIntegrator by whose leapfrog (Fincham 1992) clumps turn as they do in GrainLoop.

    YADE 2023.02a has no other scheme, 2025.2.0 another one unless this one is chosen.
    """
    newton = NewtonIntegrator(**attributes)
    if hasattr(newton, "rotAlgorithm"):
        newton.rotAlgorithm = "Fincham1992"
    return newton
