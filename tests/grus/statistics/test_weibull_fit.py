"""Fit of complete groups: estimates, invariance, coverage, goodness of fit, refusals."""

import json
from dataclasses import asdict

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.special import ndtri
from scipy.stats import binomtest, kstest, weibull_min

from grus.errors import GrusError
from grus.statistics import fit_weibull


def test_recovers_modulus_and_characteristic_strength(draw):
    fit = fit_weibull(draw([1], 10_000, 3.2, 12e6))
    assert fit.modulus == pytest.approx(3.2, rel=0.03)
    assert fit.sigma0 == pytest.approx(12e6, rel=0.015)
    assert fit.modulus_ci[0] < 3.2 < fit.modulus_ci[1]
    assert fit.sigma0_ci[0] < 12e6 < fit.sigma0_ci[1]


@pytest.mark.parametrize("n", [5, 30, 300])
@pytest.mark.parametrize("modulus", [0.7, 3.0, 25.0])
def test_agrees_with_scipy(draw, n, modulus):
    strengths = draw([2, n], n, modulus, 3.0)
    fit = fit_weibull(strengths)
    shape, _, scale = weibull_min.fit(strengths, floc=0)
    assert fit.modulus == pytest.approx(shape, rel=1e-4)
    assert fit.sigma0 == pytest.approx(scale, rel=1e-4)
    # where scipy stops early its likelihood is lower, never higher
    reached = weibull_min.logpdf(strengths, shape, 0, scale).sum()
    assert fit.log_likelihood >= reached - 1e-9 * abs(reached)
    ours = weibull_min.logpdf(strengths, fit.modulus, 0, fit.sigma0).sum()
    assert fit.log_likelihood == pytest.approx(ours, rel=1e-12)


def test_lieblein_zelen_ball_bearings():
    """23 endurance lives in 10^6 turns (Lieblein & Zelen 1956, J. Res. NBS 57:273).

    Maximum likelihood in Lawless (1982, Statistical Models and Methods for Lifetime Data):
    ln(scale) = 4.405, 1/shape = 0.476.
    """
    lives = [17.88, 28.92, 33.00, 41.52, 42.12, 45.60, 48.48, 51.84, 51.96, 54.12, 55.56, 67.80]
    lives += [68.64, 68.64, 68.88, 84.12, 93.12, 98.64, 105.12, 105.84, 127.92, 128.04, 173.40]
    fit = fit_weibull(lives)
    assert np.log(fit.sigma0) == pytest.approx(4.405, abs=1e-3)
    assert 1.0 / fit.modulus == pytest.approx(0.476, abs=1e-3)
    assert fit.p_value > 0.2


def test_units_do_not_matter(draw):
    pascals = draw([3], 40, 2.5, 8e6)
    a, b = fit_weibull(pascals), fit_weibull(pascals / 1e6)
    assert b.modulus == pytest.approx(a.modulus, rel=1e-9)
    assert b.modulus_ci == pytest.approx(a.modulus_ci, rel=1e-9)
    assert 1e6 * b.sigma0 == pytest.approx(a.sigma0, rel=1e-9)
    assert 1e6 * np.array(b.sigma0_ci) == pytest.approx(a.sigma0_ci, rel=1e-9)
    assert b.anderson_darling == pytest.approx(a.anderson_darling, rel=1e-9)
    assert b.p_value == a.p_value


def test_order_does_not_matter_and_fit_repeats(draw):
    strengths = draw([4], 25, 4.0)
    fit = fit_weibull(strengths)
    assert fit == fit_weibull(list(strengths))
    reverse = fit_weibull(strengths[::-1])
    assert reverse.modulus == pytest.approx(fit.modulus, rel=1e-12)
    assert reverse.p_value == fit.p_value


def test_power_of_the_strengths_divides_the_modulus(draw):
    strengths = draw([5], 20, 3.0)
    assert fit_weibull(strengths**2).modulus == pytest.approx(
        0.5 * fit_weibull(strengths).modulus, rel=1e-9
    )


@settings(max_examples=60, deadline=None)
@example([1.0, 1.0, 0.9999999999999991], 1e-200)
@given(
    st.lists(st.floats(1e-6, 1.0), min_size=3, max_size=12).filter(lambda x: len(set(x)) > 1),
    st.sampled_from([1e-200, 1.0, 1e9, 1e200]),
)
def test_estimate_is_the_peak_of_the_likelihood(values, scale):
    strengths = scale * np.array(values)
    if np.unique(strengths).size == 1:
        return
    fit = fit_weibull(strengths)
    assert fit.sigma0_ci[0] <= fit.sigma0 <= fit.sigma0_ci[1]
    # the quotient alone would be rounded by more than the scatter of nearly equal values
    reduced = np.log1p((strengths - strengths.max()) / strengths.max())

    def likelihood(modulus):
        z = np.exp(modulus * reduced)
        return (np.log(modulus) + modulus * reduced - np.log(z.mean())).sum()

    peak = likelihood(fit.modulus)
    assert peak >= likelihood(0.99 * fit.modulus)
    assert peak >= likelihood(1.01 * fit.modulus)


@pytest.mark.parametrize(
    "strengths",
    [
        [1e6, 1e6 * (1 + 1e-12), 1e6 * (1 - 3e-12)],
        [1e-300, 1.0, 1e300],
        [5.0] * 50 + [5.1],
        [5.0] * 50 + [4.9],
    ],
)
def test_extreme_samples_are_fitted(strengths):
    fit = fit_weibull(strengths)
    assert np.isfinite(fit.modulus) and fit.modulus > 0
    assert min(strengths) <= fit.sigma0 <= 1.1 * max(strengths)
    assert fit.modulus_ci[0] < fit.modulus_ci[1]


def test_intervals_cover_as_promised(draw):
    """600 groups of 30; at the promised 95 % such a count strays this far once in a thousand."""
    count, modulus, tenth = 600, 3.0, (-np.log(0.9)) ** (1.0 / 3.0)
    hits = np.zeros(3, dtype=int)
    for index in range(count):
        fit = fit_weibull(draw([6, index], 30, modulus))
        low, high = fit.strength_interval([0.9])
        hits += [
            fit.modulus_ci[0] < modulus < fit.modulus_ci[1],
            fit.sigma0_ci[0] < 1.0 < fit.sigma0_ci[1],
            low[0] < tenth < high[0],
        ]
    for hit in hits:
        assert binomtest(int(hit), count, 0.95).pvalue > 1e-3


def test_small_groups_are_covered_too(draw):
    fits = [fit_weibull(draw([7, index], 4, 2.0), confidence=0.8) for index in range(600)]
    hits = sum(fit.modulus_ci[0] < 2.0 < fit.modulus_ci[1] for fit in fits)
    assert binomtest(hits, 600, 0.8).pvalue > 1e-3


def test_unbiased_modulus(draw):
    fits = [fit_weibull(draw([8, index], 8, 3.0)) for index in range(800)]
    raw = np.array([fit.modulus for fit in fits])
    corrected = np.array([fit.modulus_unbiased for fit in fits])
    error = corrected.std() / np.sqrt(corrected.size)
    assert abs(corrected.mean() - 3.0) < 3.5 * error
    assert raw.mean() - 3.0 > 10 * error


def test_p_values_are_uniform_when_the_law_holds(draw):
    p_values = [fit_weibull(draw([9, i], 20, 5.0)).p_value for i in range(400)]
    assert kstest(p_values, "uniform").pvalue > 1e-3


def test_other_laws_are_rejected(draw):
    two_kinds = np.concatenate([draw([10, 0], 150, 8.0, 1.0), draw([10, 1], 150, 8.0, 4.0)])
    assert fit_weibull(two_kinds).p_value < 0.001
    uniform = np.random.Generator(np.random.PCG64(11)).random(300)
    assert fit_weibull(np.exp(0.4 * ndtri(uniform))).p_value < 0.01


def test_strength_and_survival_are_inverse(draw):
    fit = fit_weibull(draw([12], 15, 3.0, 2e6))
    shares = np.array([0.99, 0.5, 0.01])
    assert fit.survival(fit.strength(shares)) == pytest.approx(shares, rel=1e-12)
    assert fit.survival(fit.sigma0) == pytest.approx(np.exp(-1.0), rel=1e-12)
    low, high = fit.strength_interval(shares)
    assert np.all((low < fit.strength(shares)) & (fit.strength(shares) < high))
    at_sigma0 = [edge[0] for edge in fit.strength_interval([np.exp(-1.0)])]
    assert at_sigma0 == pytest.approx(fit.sigma0_ci, rel=1e-9)


def test_wider_confidence_and_other_seed(draw):
    strengths = draw([13], 30, 3.0)
    fit, wide = fit_weibull(strengths), fit_weibull(strengths, confidence=0.99)
    assert wide.modulus_ci[0] < fit.modulus_ci[0] and fit.modulus_ci[1] < wide.modulus_ci[1]
    other = fit_weibull(strengths, seed=1)
    assert other.modulus == fit.modulus
    assert other.modulus_ci != fit.modulus_ci
    assert other.modulus_ci == pytest.approx(fit.modulus_ci, rel=0.01)


def test_fit_goes_to_json_and_back(draw):
    fit = fit_weibull(draw([14], 5, 3.0))
    assert json.loads(json.dumps(asdict(fit)))["modulus"] == fit.modulus


@pytest.mark.parametrize(
    "strengths, message",
    [
        ([1.0, 2.0], "strengths: 2 values; a Weibull fit needs at least 3"),
        ([], "strengths: 0 values; a Weibull fit needs at least 3"),
        ([1.0, -2.0, 3.0], "strengths: value -2 at index 1; must be positive and finite"),
        ([1.0, 2.0, 0.0], "strengths: value 0 at index 2; must be positive and finite"),
        ([np.nan, 2.0, 3.0], "strengths: value nan at index 0; must be positive and finite"),
        ([1.0, np.inf, 3.0], "strengths: value inf at index 1; must be positive and finite"),
        ([2.0] * 4, "strengths: all 4 values equal the largest, 2; a Weibull fit needs scatter"),
        ([[1.0, 2.0, 3.0]], "strengths: shape (1, 3); must be a one-dimensional list"),
        (["weak", 1.0, 2.0], "strengths: ['weak', 1.0, 2.0]; must be a list of numbers"),
    ],
)
def test_refusals(strengths, message):
    with pytest.raises(GrusError) as refusal:
        fit_weibull(strengths)
    assert str(refusal.value) == message


@pytest.mark.parametrize(
    "options, message",
    [
        ({"confidence": 95}, "confidence: 95; must lie between 0 and 1"),
        ({"confidence": np.nan}, "confidence: nan; must lie between 0 and 1"),
        ({"seed": -1}, "seed: -1; must be a whole number, zero or more"),
        ({"seed": 1.5}, "seed: 1.5; must be a whole number, zero or more"),
        ({"censored": [True]}, "censored: 1 values for 3 strengths; must be one per strength"),
        (
            {"censored": [0, 1, 2]},
            "censored: type int64; must be true or false per strength",
        ),
    ],
)
def test_refused_options(options, message):
    with pytest.raises(GrusError) as refusal:
        fit_weibull([1.0, 2.0, 3.0], **options)
    assert str(refusal.value) == message


def test_refused_survival(draw):
    with pytest.raises(GrusError, match="^survival: 1.0; every share must lie between 0 and 1$"):
        fit_weibull(draw([15], 5, 3.0)).strength(1.0)
