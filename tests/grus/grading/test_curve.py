"""Grading curves: interpolation, characteristic sizes, refusals."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as some

from grus.errors import GrusError
from grus.grading import Grading, sieve_series

CURVE = Grading([1e-3, 10e-3, 100e-3], [0, 40, 100])


def test_straight_over_log_size():
    assert CURVE.passing_at(np.sqrt(10) * 1e-3) == pytest.approx(20)
    assert CURVE.passing_at([0.1e-3, 1e-3, 10e-3, 100e-3, 1.0]) == pytest.approx(
        [0, 0, 40, 100, 100]
    )
    assert CURVE.d10 == pytest.approx(10**0.25 * 1e-3)
    assert CURVE.d15 == pytest.approx(10**0.375 * 1e-3)
    assert CURVE.d50 == pytest.approx(10 ** (1 + 1 / 6) * 1e-3)
    assert CURVE.d60 == pytest.approx(10 ** (1 + 1 / 3) * 1e-3)
    assert CURVE.uniformity == pytest.approx(10 ** (4 / 3 - 1 / 4))
    assert CURVE.curvature == pytest.approx(10 ** (2 * 0.75 - 1 / 4 - 4 / 3))
    assert CURVE.retained == pytest.approx([0, 40, 60])


@given(some.floats(0.01, 100))
def test_size_at_is_the_inverse(percent):
    assert CURVE.passing_at(CURVE.size_at(percent)) == pytest.approx(percent)


def test_a_level_stretch_gives_its_finer_end():
    curve = Grading([1.0, 2.0, 4.0, 8.0], [0, 50, 50, 100])
    assert curve.d50 == pytest.approx(2.0)
    assert curve.size_at(100) == pytest.approx(8.0)
    assert Grading([1.0, 2.0, 4.0], [0, 100, 100]).size_at(100) == pytest.approx(2.0)


def test_table_as_users_write_it():
    curve = Grading.of_table([("19.1 mm", 100), ("9.5 mm", 0), (12.5e-3, 45.5)])
    assert curve.sizes.tolist() == [0.0095, 0.0125, 0.0191]
    assert curve.passing.tolist() == [0, 45.5, 100]


def test_masses_on_sieves():
    curve = Grading.of_masses([2.0, 3.0, 8.0, 5.0], [1, 2, 4, 1], sieves=[1.0, 3.0, 5.5, 8.0])
    assert curve.passing == pytest.approx([0, 37.5, 50, 100])  # 3.0 passes the sieve 3.0


def test_default_sieves_hold_all_masses():
    sizes = np.geomspace(0.5e-3, 30e-3, 200)
    curve = Grading.of_masses(sizes, sizes**2)
    assert curve.passing[0] == 0 and curve.passing[-1] == 100
    assert np.diff(np.log10(curve.sizes)) == pytest.approx(0.05)
    one = Grading.of_masses([2e-3], [7.0])
    assert one.passing.tolist() == [0, 100]
    assert one.sizes[0] < 2e-3 <= one.sizes[1]


def test_sieve_series():
    series = sieve_series(1e-3, 10e-3)
    assert len(series) == 22
    assert series[1] == pytest.approx(1e-3) and series[-1] == pytest.approx(10e-3)


def test_below_the_smallest_sieve_only_when_nothing_passes_it():
    curve = Grading([1e-3, 2e-3], [12, 100])
    assert curve.passing_at(1e-3) == pytest.approx(12)
    message = r"^passing = 12 % pass the smallest sieve, 0.001 m: must be known down to 0.0005 m$"
    with pytest.raises(GrusError, match=message):
        curve.passing_at([5e-4, 3e-3])
    with pytest.raises(GrusError, match="^passing = 12 % at the smallest sieve, 0.001 m: must be"):
        curve.d10


def test_arrays_are_copies_and_read_only():
    sizes = np.array([1.0, 2.0])
    curve = Grading(sizes, [0, 100])
    sizes[0] = 0.5
    assert curve.sizes[0] == 1.0
    with pytest.raises(ValueError):
        curve.passing[0] = 5


@pytest.mark.parametrize(
    "sizes, passing, message",
    [
        ([1.0], [100], "sizes = [1.0]: must be two or more sieves"),
        ([1.0, 2.0], [0, 50, 100], "shape of passing = (3,): must be (2,)"),
        ([0.0, 2.0], [0, 100], "sizes = 0.0: must be finite and > 0 m"),
        ([2.0, 1.0], [0, 100], "sizes = 1.0: must be rising"),
        ([1.0, 1.0], [0, 100], "sizes = 1.0: must be rising"),
        ([1.0, 2.0], [-1, 100], "passing = -1.0: must be in 0..100 %"),
        ([1.0, 2.0, 3.0], [0, float("nan"), 100], "passing = nan: must be in 0..100 %"),
        ([1.0, 2.0, 3.0], [0, 60, 50], "passing = 50.0: must be rising with the size"),
        ([1.0, 2.0], [0, 99.5], "passing of the largest sieve = 99.5: must be 100 %"),
        (["a", 2.0], [0, 100], "sizes = ['a', 2.0]: must be numbers"),
    ],
)
def test_refused_curves(sizes, passing, message):
    with pytest.raises(GrusError) as refusal:
        Grading(sizes, passing)
    assert str(refusal.value) == message


def test_refused_tables_and_masses():
    with pytest.raises(GrusError, match=r'^sieve = 3 kg: "kg" \(kilogram\) is not a length; allow'):
        Grading.of_table([("3 kg", 0), ("2 mm", 100)])
    with pytest.raises(GrusError, match="^masses = 0.0: must be finite and > 0$"):
        Grading.of_masses([1.0, 2.0], [1.0, 0.0])
    with pytest.raises(GrusError, match="^largest sieve = 1.5: must be at least 2.0 m, a grain$"):
        Grading.of_masses([1.0, 2.0], [1.0, 1.0], sieves=[0.5, 1.5])
    with pytest.raises(GrusError, match="^shape of sizes and masses = "):
        Grading.of_masses([], [])
