"""Specimens do not hang on the last digits of mathematical functions."""

import numpy as np
import pytest

from grus.specimen import Sphere, Stamp, agglomerate
from grus.specimen.rounding import on_grid

RADIUS = 1.3e-3


def test_lengths_keep_eight_digits_of_a_radius():
    values = RADIUS * np.random.default_rng(1).uniform(-50, 50, (200, 3))
    kept = on_grid(values, RADIUS)
    assert np.abs(kept - values).max() <= RADIUS * 2.0**-26
    assert np.unique(kept).size == kept.size


def test_last_digits_do_not_matter():
    values = RADIUS * np.random.default_rng(2).uniform(-50, 50, (200, 3))
    kept = on_grid(values, RADIUS)
    for factor in (1 - 2.0**-52, 1 + 2.0**-52):
        assert (on_grid(values * factor, RADIUS) == kept).all()


def test_rounding_again_changes_nothing():
    kept = on_grid(RADIUS * np.linspace(-3, 3, 100), RADIUS)
    assert (on_grid(kept, RADIUS) == kept).all()


@pytest.mark.parametrize("stamp", [None, Stamp(mean=2 * RADIUS, deviation=0)])
def test_elements_of_a_grain_lie_on_the_grid(stamp):
    grain = agglomerate(Sphere(12 * RADIUS), RADIUS, stamp=stamp, seed=1)
    assert (on_grid(grain.position, RADIUS) == grain.position).all()
