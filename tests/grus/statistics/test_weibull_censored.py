"""Groups in which some grains did not break."""

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.stats import binomtest, chi2, weibull_min

from grus.errors import GrusError
from grus.statistics import fit_weibull


def censored_group(strengths, limit):
    return np.minimum(strengths, limit), strengths > limit


def log_likelihood(parameters, strengths, censored):
    modulus, sigma0 = np.exp(parameters)
    broken = weibull_min.logpdf(strengths[~censored], modulus, 0, sigma0).sum()
    return broken + weibull_min.logsf(strengths[censored], modulus, 0, sigma0).sum()


def test_agrees_with_a_direct_search(draw):
    strengths, censored = censored_group(draw([30], 40, 3.0, 5.0), 5.0)
    fit = fit_weibull(strengths, censored=censored)
    found = minimize(
        lambda p: -log_likelihood(p, strengths, censored),
        [0.0, 1.0],
        method="Nelder-Mead",
        options={"xatol": 1e-9, "fatol": 1e-12},
    )
    assert [fit.modulus, fit.sigma0] == pytest.approx(np.exp(found.x), rel=1e-6)
    assert fit.log_likelihood == pytest.approx(-found.fun, rel=1e-10)
    assert (fit.n, fit.broken) == (40, int((~censored).sum()))
    assert fit.anderson_darling is fit.p_value is fit.modulus_unbiased is None


def test_interval_ends_lose_half_a_chi_square(draw):
    strengths, censored = censored_group(draw([31], 25, 2.0), 0.9)
    fit = fit_weibull(strengths, censored=censored, confidence=0.9)

    def lost(index, value):
        def free(other):
            parameters = np.insert(other, index, np.log(value))
            return -log_likelihood(parameters, strengths, censored)

        return fit.log_likelihood + minimize(free, [0.0], tol=1e-12).fun

    expected = 0.5 * chi2.ppf(0.9, 1)
    for index, interval in enumerate((fit.modulus_ci, fit.sigma0_ci)):
        for end in interval:
            assert lost(index, end) == pytest.approx(expected, rel=1e-3)


def test_no_censored_grain_means_a_complete_group(draw):
    strengths = draw([32], 12, 3.0)
    assert fit_weibull(strengths, censored=np.zeros(12, bool)) == fit_weibull(strengths)


def test_ignoring_the_mask_would_bias_the_fit(draw):
    strengths, censored = censored_group(draw([33], 2000, 3.0), 0.9)
    fit = fit_weibull(strengths, censored=censored)
    assert fit.modulus == pytest.approx(3.0, rel=0.06)
    assert fit.sigma0 == pytest.approx(1.0, rel=0.03)
    assert fit_weibull(strengths).modulus > 3.5


def test_coverage_is_near_the_promise(draw):
    """Profile likelihood is approximate: two per cent of slack at 30 grains, about 19 broken."""
    count = 400
    hits = np.zeros(2, dtype=int)
    for index in range(count):
        fit = fit_weibull(*_arguments(draw([34, index], 30, 3.0), 1.0))
        hits += [
            fit.modulus_ci[0] < 3.0 < fit.modulus_ci[1],
            fit.sigma0_ci[0] < 1.0 < fit.sigma0_ci[1],
        ]
    for hit in hits:
        assert binomtest(int(hit), count, 0.93, alternative="less").pvalue > 1e-3
        assert binomtest(int(hit), count, 0.95, alternative="greater").pvalue > 1e-3


def _arguments(strengths, limit):
    values, censored = censored_group(strengths, limit)
    return values, 0.95, 0, censored


def test_units_do_not_matter(draw):
    strengths, censored = censored_group(draw([35], 30, 3.0), 1.0)
    a = fit_weibull(strengths, censored=censored)
    b = fit_weibull(1e6 * strengths, censored=censored)
    assert b.modulus_ci == pytest.approx(a.modulus_ci, rel=1e-9)
    assert b.sigma0_ci == pytest.approx(1e6 * np.array(a.sigma0_ci), rel=1e-9)


def test_refusals():
    with pytest.raises(
        GrusError, match="^strengths: 2 broken grains; a Weibull fit needs at least 3$"
    ):
        fit_weibull([1.0, 2.0, 3.0], censored=[False, False, True])
    with pytest.raises(GrusError, match="^strengths: all 3 broken grains equal the largest, 3;"):
        fit_weibull([3.0, 3.0, 3.0, 1.0], censored=[False, False, False, True])
