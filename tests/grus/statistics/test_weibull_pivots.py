"""The simulated pivots against published tables."""

import numpy as np
import pytest

from grus.statistics.likelihood import maximum_likelihood, maximum_likelihood_rows
from grus.statistics.pivots import simulate_pivots


@pytest.mark.parametrize(
    "n, low, high", [(5, 0.683, 2.779), (10, 0.738, 1.807), (20, 0.791, 1.449)]
)
def test_modulus_ratio_of_thoman_bain_antle(n, low, high):
    """5 and 95 % points of m^/m (Thoman, Bain & Antle 1969, Technometrics 11:445, table 1)."""
    pivots = simulate_pivots(n, 0)
    assert np.quantile(pivots.modulus, [0.05, 0.95]) == pytest.approx([low, high], rel=0.03)


@pytest.mark.parametrize("n, factor", [(5, 0.700), (10, 0.859), (30, 0.955)])
def test_unbiasing_factors_of_astm_c1239(n, factor):
    assert 1.0 / simulate_pivots(n, 0).modulus.mean() == pytest.approx(factor, abs=0.015)


@pytest.mark.parametrize("n", [10, 50, 500])
def test_anderson_darling_points_of_stephens(n):
    """10, 5 and 1 % points 0.637, 0.757, 1.038 of (1 + 0.2/sqrt(n)) A^2 (Stephens 1977,
    Biometrika 64:583), both parameters estimated; an approximation good to some per cent."""
    distance = (1.0 + 0.2 / np.sqrt(n)) * simulate_pivots(n, 0).distance
    assert np.quantile(distance, [0.9, 0.95, 0.99]) == pytest.approx(
        [0.637, 0.757, 1.038], rel=0.05
    )


def test_rows_agree_with_single_fits(draw):
    logs = np.log([draw([20, index], 6, 1.0) for index in range(50)])
    modulus, location = maximum_likelihood_rows(logs)
    for row, m, u in zip(logs, modulus, location):
        assert (m, u) == pytest.approx(maximum_likelihood(row, np.ones(6, bool)), rel=1e-9)


def test_p_value_counts_the_far_samples():
    pivots = simulate_pivots(10, 0)
    total = pivots.distance.size + 1
    assert pivots.p_value(np.inf) == 1 / total
    assert pivots.p_value(0.0) == 1.0
    assert pivots.p_value(np.median(pivots.distance)) == pytest.approx(0.5, abs=1e-4)
