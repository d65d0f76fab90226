"""Compression and swelling index, and the readings of first loading."""

import numpy as np
import pytest

from grus.compression import compression_index, first_loading
from grus.errors import GrusError


def test_exact_line_in_any_order(stages):
    value = 0.3 - 0.02 * np.log10(stages)
    for order in (slice(None), slice(None, None, -1)):
        found = compression_index(stages[order], value[order])
        assert found.value == pytest.approx(0.02)
        assert found.interval == pytest.approx((0.02, 0.02), abs=1e-4)


@pytest.mark.parametrize("wander", [False, True])
def test_interval_holds_the_truth(wander, stream):
    covered, runs = 0, 100
    stress = np.geomspace(1e5, 1e6, 30)
    for run in range(runs):
        noise = 1e-3 * stream(11, run).normal(30)
        value = 0.3 - 0.02 * np.log10(stress) + (np.cumsum(noise) if wander else noise)
        low, high = compression_index(stress, value).interval
        covered += low <= 0.02 <= high
    assert covered >= 0.85 * runs


def test_first_loading():
    stress = [0, 1, 2, 2, 1, 0.5, 1.5, 2, 3, 2.9, 3.1]
    mask = [False, True, True, False, False, False, False, False, True, False, True]
    assert first_loading(stress).tolist() == mask
    assert first_loading([-1.0, 0.0]).tolist() == [False, False]


@pytest.mark.parametrize(
    "stress, message",
    [
        ([1.0, 2.0], "number of readings = 2: must be at least 3"),
        ([0.0, 1.0, 2.0], "lowest stress = 0.0: must be > 0 Pa"),
        ([2.0, 2.0, 2.0], "stress = 2 throughout: must be of different values"),
    ],
)
def test_refusals(stress, message):
    with pytest.raises(GrusError) as refusal:
        compression_index(stress, np.zeros(len(stress)))
    assert str(refusal.value) == message
