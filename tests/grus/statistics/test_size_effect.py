"""Weibull regression of strength on diameter."""

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.stats import binomtest, chi2, weibull_min

from grus.errors import GrusError
from grus.statistics import fit_weibull, size_effect

DIAMETERS = (0.010, 0.014, 0.020, 0.028)


def groups(draw, ids, n, modulus, slope):
    return [
        draw([*ids, index], n, modulus, 5e6 * (diameter / 0.01) ** slope)
        for index, diameter in enumerate(DIAMETERS)
    ]


def test_recovers_slope_and_modulus(draw):
    effect = size_effect(DIAMETERS, groups(draw, [50], 1000, 3.0, -1.0), 3)
    assert effect.modulus == pytest.approx(3.0, rel=0.04)
    assert effect.slope == pytest.approx(-1.0, abs=0.05)
    assert effect.expected_slope == -3.0 / effect.modulus
    assert effect.strength(0.01) == pytest.approx(5e6, rel=0.03)
    assert effect.n == 4000
    assert effect.slope_ci[0] < -1.0 < effect.slope_ci[1]
    assert effect.expected_slope_ci == pytest.approx([-3.0 / m for m in effect.modulus_ci])
    assert effect.agreement_p_value > 0.01
    assert effect.model_p_value > 0.01


def test_agrees_with_a_direct_search(draw):
    samples = groups(draw, [51], 12, 2.5, -0.5)
    effect = size_effect(DIAMETERS, samples, 2)
    x = np.repeat(np.log(np.array(DIAMETERS) / 0.01), 12)
    y = np.concatenate(samples) / 5e6

    def loss(p, slope=None):
        b = p[2] if slope is None else slope(p)
        return -weibull_min.logpdf(y, np.exp(p[0]), 0, np.exp(p[1] + b * x)).sum()

    options = {"xatol": 1e-10, "fatol": 1e-13, "maxiter": 5000}
    free = minimize(loss, [0.5, 0.0, 0.0], method="Nelder-Mead", options=options)
    assert effect.modulus == pytest.approx(np.exp(free.x[0]), rel=1e-6)
    assert effect.slope == pytest.approx(free.x[2], rel=1e-6)
    tied = minimize(
        lambda p: loss(p, lambda q: -2.0 / np.exp(q[0])),
        [0.5, 0.0],
        method="Nelder-Mead",
        options=options,
    )
    agreement = chi2.sf(2.0 * (tied.fun - free.fun), 1)
    assert effect.agreement_p_value == pytest.approx(agreement, rel=1e-5)
    separate = sum(fit_weibull(group / 5e6).log_likelihood for group in samples)
    assert effect.model_p_value == pytest.approx(chi2.sf(2.0 * (separate + free.fun), 5), rel=1e-5)


def test_units_do_not_matter(draw):
    samples = groups(draw, [52], 15, 3.0, -1.0)
    a = size_effect(DIAMETERS, samples, 3)
    b = size_effect(1e3 * np.array(DIAMETERS), [group / 1e6 for group in samples], 3)
    for name in ("modulus", "slope", "agreement_p_value", "model_p_value"):
        assert getattr(b, name) == pytest.approx(getattr(a, name), rel=1e-8)
    assert b.slope_ci == pytest.approx(a.slope_ci, rel=1e-8)
    assert b.strength(10.0) == pytest.approx(a.strength(0.01) / 1e6, rel=1e-8)


def test_intervals_and_tests_keep_their_promise(draw):
    """Likelihood ratios are asymptotic: two per cent of slack for 4 x 15 grains."""
    count = 300
    covered = np.zeros(2, dtype=int)
    rejected = np.zeros(2, dtype=int)
    for index in range(count):
        effect = size_effect(DIAMETERS, groups(draw, [53, index], 15, 3.0, -1.0), 3)
        covered += [
            effect.slope_ci[0] < -1.0 < effect.slope_ci[1],
            effect.expected_slope_ci[0] < -1.0 < effect.expected_slope_ci[1],
        ]
        rejected += [effect.agreement_p_value < 0.05, effect.model_p_value < 0.05]
    for hits in (*covered, *(count - rejected)):
        assert binomtest(int(hits), count, 0.93, alternative="less").pvalue > 1e-3
        assert binomtest(int(hits), count, 0.95, alternative="greater").pvalue > 1e-3


def test_another_slope_is_noticed(draw):
    effect = size_effect(DIAMETERS, groups(draw, [54], 50, 3.0, 0.0), 3)
    assert effect.agreement_p_value < 1e-6
    assert effect.slope_ci[0] < 0.0 < effect.slope_ci[1]


def test_different_moduli_are_noticed(draw):
    samples = [draw([55, 0], 60, 1.5), draw([55, 1], 60, 6.0)]
    assert size_effect([1.0, 2.0], samples, 3).model_p_value < 1e-6


def test_fits_and_strengths_give_the_same(draw):
    samples = groups(draw, [56], 10, 3.0, -1.0)
    assert size_effect(DIAMETERS, [fit_weibull(g) for g in samples], 3) == size_effect(
        DIAMETERS, samples, 3
    )


def test_censored_groups(draw):
    limit = 4e6
    fits = [
        fit_weibull(np.minimum(g, limit), censored=g > limit)
        for g in groups(draw, [57], 1000, 3.0, -1.0)
    ]
    effect = size_effect(DIAMETERS, fits, 3)
    assert effect.modulus == pytest.approx(3.0, rel=0.05)
    assert effect.slope == pytest.approx(-1.0, abs=0.06)


@pytest.mark.parametrize(
    "diameters, dimension, message",
    [
        ([1.0, 1.0], 3, "diameters: [1.0, 1.0]; a size effect needs at least two sizes"),
        ([1.0, 0.0], 3, "diameters: value 0 at index 1; must be positive and finite"),
        ([1.0, 2.0, 3.0], 3, "diameters: shape (3,) for 2 groups; must be one per group"),
        ([1.0, 2.0], 4, "dimension: 4; must be 2 or 3"),
    ],
)
def test_refusals(draw, diameters, dimension, message):
    samples = [draw([58, index], 5, 3.0) for index in range(2)]
    with pytest.raises(GrusError) as refusal:
        size_effect(diameters, samples, dimension)
    assert str(refusal.value) == message


def test_fits_of_another_confidence_are_refused(draw):
    fits = [fit_weibull(draw([59, index], 5, 3.0), confidence=0.9) for index in range(2)]
    with pytest.raises(GrusError, match="^groups: fit of confidence 0.9; must be 0.95"):
        size_effect([1.0, 2.0], fits, 3)
