"""What differs between the supported YADEs is chosen, not left to the YADE at hand."""

import pytest
from yade.wrapper import CohFrictMat, Ip2_CohFrictMat_CohFrictMat_CohFrictPhys

from grus.host.differences import MOMENT_BOUNDS, leapfrog, set_moment_bounds
from grus.host.locate import installed_version


def test_only_newer_versions_have_moment_bounds():
    assert MOMENT_BOUNDS == (installed_version() != "2023.02a")


def test_moments_are_elastic_without_bounds():
    material, physics = CohFrictMat(), Ip2_CohFrictMat_CohFrictMat_CohFrictPhys()
    set_moment_bounds(material, physics, False)
    assert material.etaRoll < 0 and material.etaTwist < 0
    if MOMENT_BOUNDS:
        assert physics.rollingCohesion.val == physics.twistingCohesion.val == -1


def test_bounds_that_do_not_exist_are_refused():
    material, physics = CohFrictMat(), Ip2_CohFrictMat_CohFrictMat_CohFrictPhys()
    if MOMENT_BOUNDS:
        set_moment_bounds(material, physics, True)
        assert material.etaRoll == material.etaTwist == 0
    else:
        with pytest.raises(ValueError, match="^bonds of CohFrict never break by moments in this"):
            set_moment_bounds(material, physics, True)


def test_clumps_turn_by_one_scheme():
    newton = leapfrog(damping=0.3)
    assert newton.damping == 0.3 and newton.exactAsphericalRot
    if hasattr(newton, "rotAlgorithm"):
        assert str(newton.rotAlgorithm).endswith("Fincham1992")
