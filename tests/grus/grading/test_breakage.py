"""Measures of breakage against values computed by hand."""

import numpy as np
import pytest

from grus.errors import GrusError
from grus.grading import (
    Breakage,
    Grading,
    einav,
    hardin,
    lee_farhoomand,
    marsal,
    new_surface,
    power_law_grading,
)

# straight lines over two decades, so that areas over log10 d are those of triangles
BEFORE = Grading([1e-3, 100e-3], [0, 100])
AFTER = Grading([0.1e-3, 100e-3], [0, 100])


def test_nothing_broke():
    grading = Grading([10e-3, 20e-3, 100e-3], [0, 30, 100])
    measures = Breakage.between(grading, grading, dimension=3, smallest=0.1e-3)
    assert measures == Breakage(0.0, 0.0, 0.0, 1.0, 0.0)


def test_hardin_by_hand():
    # over log10 d from 0.01 to 100 mm: before 2/2 below the curve, after 3/2, in all 4
    assert hardin(BEFORE, AFTER, cutoff=1e-5) == pytest.approx((1.5 - 1.0) / (4.0 - 1.0))
    # from 1 mm: before 1, after (1/3 + 1)/2 * 2
    assert hardin(BEFORE, AFTER, cutoff=1e-3) == pytest.approx((4 / 3 - 1) / (2 - 1))


def test_hardin_cutoff_is_at_0074_mm():
    potential = np.log10(100 / 0.074) - 1.0
    assert hardin(BEFORE, AFTER) == pytest.approx(0.5 / potential)


def test_hardin_of_silt_alone_is_one():
    assert hardin(BEFORE, Grading([0.01e-3, 0.074e-3], [0, 100])) == pytest.approx(1.0)


def test_einav_by_hand():
    # fractal dimension 2, from 1 to 10 mm: share (d - 1)/9, of area 1/ln 10 - 1/9 over log10 d
    before = Grading([1e-3, 10e-3], [0, 100])
    after = Grading([1e-3, np.sqrt(10) * 1e-3, 10e-3], [0, 60, 100])
    ultimate = 1 / np.log(10) - 1 / 9
    found = einav(Grading([5e-3, 10e-3], [0, 100]), before, 1e-3, fractal_dimension=2)
    start = np.log10(2) / 2
    assert found == pytest.approx((0.5 - start) / (ultimate - start))
    with pytest.raises(GrusError, match="^grading before = as fine as the ultimate: must be coar"):
        einav(before, after, 1e-3, fractal_dimension=2)


@pytest.mark.parametrize("fractal_dimension", [2.0, 2.6, 2.9])
def test_einav_of_the_ultimate_grading_is_one(fractal_dimension):
    before = Grading([9.5e-3, 19.1e-3], [0, 100])
    ultimate = power_law_grading(0.1e-3, 19.1e-3, 3 - fractal_dimension, points=2001)
    assert einav(before, ultimate, 0.1e-3, fractal_dimension) == pytest.approx(1.0, abs=1e-5)
    half = Grading(ultimate.sizes, 0.5 * (ultimate.passing + before.passing_at(ultimate.sizes)))
    assert einav(before, half, 0.1e-3, fractal_dimension) == pytest.approx(0.5, abs=1e-3)


def test_marsal_by_hand():
    sizes = [1.0, 2.0, 4.0, 8.0]
    before = Grading(sizes, [0, 20, 60, 100])  # retained 0, 20, 40, 40
    after = Grading(sizes, [10, 40, 65, 100])  # retained 10, 30, 25, 35
    assert marsal(before, after) == pytest.approx(15 + 5)
    assert marsal(before, after, sieves=[2.0, 8.0]) == pytest.approx(20)


def test_marsal_of_all_mass_gone_finer():
    assert marsal(Grading([4.0, 8.0], [0, 100]), Grading([1.0, 2.0], [0, 100])) == pytest.approx(
        100
    )


def test_lee_and_farhoomand_by_hand():
    assert lee_farhoomand(BEFORE, AFTER) == pytest.approx(10 ** (0.30 - (-1 + 0.45)))


def test_new_surface_of_halved_grains():
    # grains of one size nearly: specific surface 6/d and 4/d doubles
    before, after = (Grading([d, 1.0001 * d], [0, 100]) for d in (10e-3, 5e-3))
    assert new_surface(before, after, 3) == pytest.approx(6 / 10e-3, rel=1e-4)
    assert new_surface(before, after, 2) == pytest.approx(4 / 10e-3, rel=1e-4)


def test_more_breakage_gives_larger_measures():
    steps = [Grading([s * 1e-3, 19.1e-3], [0, 100]) for s in (9.5, 5.0, 2.0, 1.0)]
    measures = [Breakage.between(steps[0], s, dimension=2, smallest=0.5e-3) for s in steps]
    for name in ("hardin", "einav", "marsal", "lee_farhoomand", "new_surface"):
        values = [getattr(measure, name) for measure in measures]
        assert (np.diff(values) > 0).all(), name


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda: hardin(BEFORE, AFTER, cutoff=0.2), "cutoff = 0.2: must be below 0.1 m"),
        (lambda: einav(BEFORE, AFTER, 0.1), "smallest = 0.1: must be below 0.1 m"),
        (lambda: einav(BEFORE, AFTER, 1e-4, 3.0), "fractal_dimension = 3.0: must be in (0, 3)"),
        (lambda: marsal(BEFORE, AFTER, [2.0, 1.0]), "sieves = [2.0, 1.0]: must be rising"),
        (lambda: new_surface(BEFORE, AFTER, 1), "dimension = 1: must be 2 or 3"),
        (
            lambda: hardin(BEFORE, Grading([1e-3, 0.1], [8, 100])),
            "passing = 8 % pass the smallest sieve, 0.001 m: must be known down to 7.4e-05 m",
        ),
    ],
)
def test_refusals(call, message):
    with pytest.raises(GrusError) as refusal:
        call()
    assert str(refusal.value).startswith(message)
