"""Whether what is left has an order."""

import numpy as np
import pytest

from grus.diagnosis.whiteness import whiteness


def of(rest: np.ndarray):
    return whiteness(np.asarray(rest, dtype=float), np.eye(len(rest)))


@pytest.mark.parametrize("seed", range(5))
def test_noise_is_white(seed):
    assert of(np.random.default_rng(seed).standard_normal(40)).smallest > 0.01


@pytest.mark.parametrize("seed", range(5))
def test_a_slow_wave_is_not(seed):
    noise = np.random.default_rng(seed).standard_normal(40)
    assert of(2 * np.sin(np.arange(40) / 4) + noise).smallest < 0.01


def test_what_is_far_less_than_its_noise_has_no_order_that_counts():
    assert of(0.05 * np.sin(np.arange(40) / 4)).neighbours > 0.5


def test_too_much_is_told_by_its_size():
    assert of(np.tile([3.0, -3.0], 10)).chi_squared < 1e-6


def test_correlation_of_the_noise_is_taken_out():
    generator = np.random.default_rng(3)
    covariance = np.exp(-np.abs(np.subtract.outer(np.arange(40), np.arange(40))) / 5)
    rest = np.linalg.cholesky(covariance) @ generator.standard_normal(40)
    assert whiteness(rest, covariance).smallest > 0.01
    assert of(rest).smallest < 0.01
