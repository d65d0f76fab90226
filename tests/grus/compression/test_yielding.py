"""Yield of compression curves: found where it is, with an honest interval, and not where it is not."""

import numpy as np
import pytest

from grus.compression import yield_stress
from grus.errors import GrusError

YIELD = 500e3


def bilinear(stress, before=0.005, after=0.035, width=0.0):
    decades = np.log10(stress / YIELD)
    bend = width * np.logaddexp(0, decades / width) if width else np.maximum(decades, 0)
    return 0.25 - before * decades - (after - before) * bend


@pytest.mark.parametrize("width", [0.0, 0.05, 0.1])
@pytest.mark.parametrize("record", ["stages", "dense"])
def test_exact_curve(record, width, request):
    stress = request.getfixturevalue(record)
    found = yield_stress(stress, bilinear(stress, width=width))
    assert found.stress == pytest.approx(YIELD, rel=1e-3)
    assert found.interval[0] <= found.stress <= found.interval[1]
    assert found.interval == pytest.approx((YIELD, YIELD), rel=0.05)
    assert found.void_ratio == pytest.approx(0.25, abs=1e-5)
    assert found.index_before == pytest.approx(0.005, abs=2e-4)
    assert found.compression_index == pytest.approx(0.035, abs=2e-4)
    assert found.width == pytest.approx(width)
    assert found.evidence > 10
    assert found.sharpest_bend == pytest.approx(YIELD, rel=0.1)
    assert found.line(stress) == pytest.approx(bilinear(stress, width=width), abs=1e-5)


@pytest.mark.parametrize("record, noise, runs", [("stages", 2e-4, 40), ("dense", 1e-3, 12)])
def test_interval_holds_the_truth(record, noise, runs, stream, request):
    stress = request.getfixturevalue(record)
    covered, ratios = 0, []
    for run in range(runs):
        found = yield_stress(stress, bilinear(stress) + noise * stream(1, run).normal(len(stress)))
        covered += found.interval[0] <= YIELD <= found.interval[1]
        ratios.append(found.stress / YIELD)
    assert covered >= 0.85 * runs
    assert np.median(ratios) == pytest.approx(1.0, abs=0.03)
    assert max(ratios) / min(ratios) < 1.3


@pytest.mark.parametrize("width", [0.013, 0.04, 0.083])
def test_interval_holds_for_bends_of_any_width(width, stream):
    # none of these widths is one that the fit starts from
    stress, covered, runs = np.geomspace(5e3, 1e6, 400), 0, 10
    for run in range(runs):
        value = bilinear(stress, width=width) + 2e-4 * stream(12, run).normal(400)
        low, high = yield_stress(stress, value).interval
        covered += low <= YIELD <= high
    assert covered >= 8


LAWS = {
    "line": lambda s: 0.30 - 0.02 * np.log10(s / 1e5),
    "elastic": lambda s: 0.25 - 0.02 * s / 1e6,
    "janbu": lambda s: 0.25 - 0.02 * (s / 1e6) ** 0.6,
    "flattening": lambda s: 0.25 + 0.03 * np.maximum(np.log10(s / YIELD), 0) - 0.05 * np.log10(s),
}


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("noise", [0.0, 2e-4])
@pytest.mark.parametrize("record, runs", [("stages", 25), ("dense", 4)])
def test_nothing_where_there_is_no_yield(law, noise, record, runs, stream, request):
    stress = request.getfixturevalue(record)
    alarms = 0
    for run in range(runs if noise else 1):
        value = LAWS[law](stress) + noise * stream(2, run).normal(len(stress))
        alarms += yield_stress(stress, value) is not None
    assert alarms <= 0.1 * runs


def test_level_curve_has_no_yield(stages):
    assert yield_stress(stages, np.full(10, 0.25)) is None


def test_elastic_before_yield_is_found_within_a_few_per_cent(dense, stages):
    for stress in (stages, dense):
        value = 0.25 - 0.01 * np.minimum(stress, YIELD) / 1e6
        value -= 0.04 * np.maximum(np.log10(stress / YIELD), 0)
        assert yield_stress(stress, value).stress == pytest.approx(YIELD, rel=0.05)


def test_unit_and_scale_do_not_matter(stages, stream):
    value = bilinear(stages) + 2e-4 * stream(3).normal(10)
    found = yield_stress(stages, value)
    scaled = yield_stress(1e-3 * stages, 7.0 * value)
    assert scaled.stress == pytest.approx(1e-3 * found.stress)
    assert scaled.interval == pytest.approx(tuple(1e-3 * end for end in found.interval))
    assert scaled.compression_index == pytest.approx(7.0 * found.compression_index)


def test_unloading_and_holds_do_not_matter(dense):
    loop = np.concatenate([np.geomspace(3e5, 3e4, 50), np.geomspace(3e4, 3e5, 50)])
    cut = np.searchsorted(dense, 3e5)
    stress = np.concatenate([dense[:cut], loop, dense[cut:], np.full(30, 0.99e6)])
    highest = np.maximum.accumulate(stress)
    value = bilinear(highest) + 0.001 * np.log10(highest / stress)
    plain = yield_stress(dense, bilinear(dense))
    assert yield_stress(stress, value).stress == pytest.approx(plain.stress, rel=1e-3)


def test_seating_is_left_out(dense):
    toe = bilinear(dense) + 0.02 * np.maximum(np.log10(2e4 / dense), 0)
    assert yield_stress(dense, toe, seating=3e4).stress == pytest.approx(YIELD, rel=0.01)


def test_higher_confidence_gives_a_wider_interval(stages, stream):
    value = bilinear(stages) + 2e-4 * stream(4).normal(10)
    widths = []
    for confidence in (0.5, 0.9, 0.99):
        low, high = yield_stress(stages, value, confidence=confidence).interval
        widths.append(high / low)
    assert widths[0] < widths[1] < widths[2]


@pytest.mark.parametrize(
    "change, message",
    [
        ({"stress": np.arange(1.0, 6.0)}, "shape of void_ratio = (10,): must be (5,)"),
        ({"void_ratio": np.full(10, np.nan)}, "void_ratio = nan at index 0: must be finite"),
        ({"stress": np.full(10, 1e5)}, "readings of first loading = 1: must be at least 7"),
        ({"stress": np.ones((2, 5))}, "shape of stress = (2, 5): must be one column"),
        ({"seating": -1.0}, "seating = -1.0: must be finite and >= 0 Pa"),
        ({"seating": 5e5}, "readings of first loading = 6: must be at least 7"),
        (
            {
                "stress": np.concatenate([1e5 + np.arange(200.0), 1e6 + np.arange(200.0)]),
                "void_ratio": np.linspace(0.25, 0.24, 400),
            },
            "readings apart in log stress = 2: must be at least 6",
        ),
        ({"confidence": 95}, "confidence = 95: must be in (0, 1)"),
    ],
)
def test_refusals(change, message, stages):
    with pytest.raises(GrusError) as refusal:
        yield_stress(**({"stress": stages, "void_ratio": bilinear(stages)} | change))
    assert str(refusal.value) == message
