"""Numbers of grains: moments, power laws, the drawing of diameters."""

import numpy as np
import pytest
from scipy.integrate import quad

from grus.errors import GrusError
from grus.grading import (
    Grading,
    power_law_grading,
    power_law_of_rms,
    rms_diameter,
    sample_diameters,
)

SMALLEST, LARGEST, RMS = 9.5e-3, 19.1e-3, 12.6e-3


def generator(seed):
    return np.random.Generator(np.random.PCG64(np.random.SeedSequence(seed, spawn_key=(3,))))


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("exponent", [-1.7, 0.0, 0.4, 3.0])
def test_rms_diameter_against_quadrature(dimension, exponent):
    def moment(power):
        return quad(lambda d: d ** (exponent - 1 + power - dimension), SMALLEST, LARGEST)[0]

    grading = power_law_grading(SMALLEST, LARGEST, exponent, points=801)
    expected = np.sqrt(moment(2) / moment(0))
    assert rms_diameter(grading, dimension) == pytest.approx(expected, rel=1e-6)


def test_uniform_by_number_has_the_mean_that_the_paper_excludes():
    grading = power_law_grading(SMALLEST, LARGEST, 3.0, points=801)
    assert rms_diameter(grading, 2) == pytest.approx(14.57e-3, abs=0.01e-3)


@pytest.mark.parametrize("dimension", [2, 3])
def test_grading_of_given_rms(dimension):
    grading = power_law_of_rms(SMALLEST, LARGEST, RMS, dimension)
    assert rms_diameter(grading, dimension) == pytest.approx(RMS, rel=1e-12)
    assert grading.sizes[[0, -1]] == pytest.approx([SMALLEST, LARGEST])
    assert grading.passing[[0, -1]].tolist() == [0, 100]


def test_discs_of_the_paper_fill_its_box():
    grading = power_law_of_rms(SMALLEST, LARGEST, RMS, 2)
    solids = 0.474 * 0.500 / 1.25
    diameters = sample_diameters(grading, 2, generator(1), measure=solids)
    assert len(diameters) == pytest.approx(1520, abs=2)
    assert np.pi / 4 * (diameters**2).sum() == pytest.approx(solids, rel=1e-3)


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("count, deviation", [(30, 12.0), (100, 4.0), (1000, 0.6)])
def test_sample_follows_the_curve_by_mass(dimension, count, deviation):
    grading = power_law_of_rms(SMALLEST, LARGEST, RMS, dimension)
    for seed in range(20):
        diameters = sample_diameters(grading, dimension, generator(seed), count=count)
        assert diameters.shape == (count,)
        assert SMALLEST <= diameters.min() and diameters.max() <= LARGEST
        drawn = Grading.of_masses(diameters, diameters**dimension, grading.sizes)
        assert np.abs(drawn.passing - grading.passing).max() < deviation


def test_sample_of_a_wide_gap_graded_curve():
    grading = Grading([1e-3, 2e-3, 8e-3, 16e-3, 32e-3], [0, 30, 30, 100, 100])
    diameters = sample_diameters(grading, 3, generator(2), count=4000)
    assert not ((diameters > 2.001e-3) & (diameters < 7.999e-3)).any()
    drawn = Grading.of_masses(diameters, diameters**3, grading.sizes)
    assert drawn.passing == pytest.approx(grading.passing, abs=1.0)


def test_sample_is_fixed_by_its_stream_and_in_random_order():
    grading = power_law_grading(SMALLEST, LARGEST, 1.0)
    first, again, other = (
        sample_diameters(grading, 2, generator(seed), count=50) for seed in (4, 4, 5)
    )
    assert (first == again).all()
    assert not (first == other).any()
    assert 10 < (np.diff(first) > 0).sum() < 40


def test_steep_power_laws_are_nearly_of_one_size():
    assert power_law_grading(1.0, 2.0, 300.0).size_at(1) > 1.95
    assert power_law_grading(1.0, 2.0, -300.0).size_at(99) < 1.05
    assert power_law_grading(1.0, 4.0, 1e-9).d50 == pytest.approx(2.0)
    assert power_law_grading(1.0, 4.0, 0.0).d50 == pytest.approx(2.0)


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda g: sample_diameters(g, 2, generator(0)), "count, measure = (None, None): must be"),
        (lambda g: sample_diameters(g, 4, generator(0), count=1), "dimension = 4: must be 2 or 3"),
        (lambda g: sample_diameters(g, 2, generator(0), count=0), "count = 0: must be a whole"),
        (lambda g: sample_diameters(g, 2, generator(0), measure=1e-5), "measure = 1e-05: must be"),
        (lambda g: power_law_of_rms(1.0, 2.0, 2.5, 2), "rms = 2.5: must be between"),
        (lambda g: power_law_grading(2.0, 1.0, 1.0), "largest = 1.0: must be finite and above"),
        (
            lambda g: rms_diameter(Grading([1.0, 2.0], [5, 100]), 2),
            "passing of the smallest sieve = 5.0: must be 0 %",
        ),
    ],
)
def test_refusals(call, message):
    with pytest.raises(GrusError) as refusal:
        call(power_law_grading(SMALLEST, LARGEST, 1.0))
    assert str(refusal.value).startswith(message)
