"""Mean-rank survival probabilities."""

import numpy as np
import pytest

from grus.errors import GrusError
from grus.statistics import fit_weibull, survival_points


def test_complete_group_has_mean_ranks():
    points = survival_points([3.0, 1.0, 2.0, 5.0])
    assert points.strength.tolist() == [1.0, 2.0, 3.0, 5.0]
    assert points.survival == pytest.approx([0.8, 0.6, 0.4, 0.2], rel=1e-12)


def test_johnson_adjusted_ranks():
    """Seven grains, the second and the fourth unbroken: increments 8/8, 7/6 and 5.8333/4."""
    strengths = [10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0]
    unbroken = [False, True, False, True, False, False, False]
    points = survival_points(strengths, unbroken)
    ranks = 8.0 * (1.0 - points.survival)
    second = 1.0 + 7.0 / 6.0
    step = (8.0 - second) / 4.0
    expected = [1.0, second, second + step, second + 2 * step, second + 3 * step]
    assert points.strength.tolist() == [10.0, 30.0, 50.0, 60.0, 70.0]
    assert ranks == pytest.approx(expected, rel=1e-12)


def test_censoring_at_the_end_leaves_the_ranks_below():
    points = survival_points([1.0, 2.0, 3.0, 4.0, 4.0], [False, False, False, True, True])
    assert points.survival == pytest.approx(1.0 - np.array([1, 2, 3]) / 6.0, rel=1e-12)


def test_broken_grains_come_first_at_equal_strength():
    a = survival_points([1.0, 2.0, 2.0, 3.0], [False, True, False, False])
    b = survival_points([1.0, 2.0, 2.0, 3.0], [False, False, True, False])
    assert a.survival == pytest.approx(b.survival, rel=1e-12)
    assert a.survival[1] == pytest.approx(0.6, rel=1e-12)


def test_points_lie_on_the_fitted_line_of_a_large_group(draw):
    strengths = draw([40], 2000, 4.0, 7e6)
    points = survival_points(strengths)
    fit = fit_weibull(strengths)
    middle = (points.survival > 0.05) & (points.survival < 0.95)
    slope, intercept = np.polyfit(points.abscissa[middle], points.ordinate[middle], 1)
    assert slope == pytest.approx(fit.modulus, rel=0.05)
    assert -intercept / slope == pytest.approx(np.log(fit.sigma0), rel=0.005)


def test_refuses_what_the_fit_refuses():
    with pytest.raises(GrusError, match="^strengths: value -1 at index 0; must be positive"):
        survival_points([-1.0, 2.0, 3.0])
