"""Onset of sustained breakage: found where it is, with an honest interval, and only there."""

import numpy as np
import pytest

from grus.compression import breakage_onset
from grus.errors import GrusError

ONSET = 400e3


def expected(stress, rate=600.0, early=3.0):
    """Broken bonds: a few from the start, many from the onset on, both per decade of stress."""
    decades = np.log10(stress / stress[0])
    return early * decades + rate * np.maximum(np.log10(stress / ONSET), 0)


def with_start(stages):
    return np.concatenate([[5e3], stages])


@pytest.mark.parametrize("record", ["stages", "dense"])
def test_exact_curve(record, request):
    stress = request.getfixturevalue(record)
    stress = with_start(stress) if record == "stages" else stress
    found = breakage_onset(stress, expected(stress, early=0.0))
    assert found.stress == pytest.approx(ONSET, rel=2e-3)
    assert found.interval[0] <= ONSET * 1.002 and ONSET * 0.998 <= found.interval[1]
    assert found.interval[1] / found.interval[0] < 1.1
    assert found.rate == pytest.approx(600.0, rel=5e-3)
    assert found.rate_before == pytest.approx(0.0, abs=0.1)
    assert found.line(1e6) == pytest.approx(expected(stress, early=0.0)[-1], rel=5e-3)
    first = stress[stress > ONSET][0]
    before = stress[stress <= ONSET][-1]
    assert found.first_break == first
    assert found.first_interval == (before, first)


@pytest.mark.parametrize("record, runs", [("stages", 40), ("dense", 20)])
@pytest.mark.parametrize("burst, unit", [(1, 1.0), (1, 1 / 2350), (5, 1.0)])
def test_interval_holds_the_truth(record, runs, burst, unit, stream, request):
    stress = request.getfixturevalue(record)
    stress = with_start(stress) if record == "stages" else stress
    covered, places = 0, []
    for run in range(runs):
        broken = unit * burst * stream(5, run).events(expected(stress) / burst)
        found = breakage_onset(stress, broken)
        covered += found.interval[0] <= ONSET <= found.interval[1]
        places.append(found.stress)
    assert covered >= 0.9 * runs
    assert np.median(places) == pytest.approx(ONSET, rel=0.05)


@pytest.mark.parametrize("record, runs", [("stages", 50), ("dense", 20)])
@pytest.mark.parametrize("total", [20, 400])
def test_no_onset_when_breakage_is_steady(record, runs, total, stream, request):
    stress = request.getfixturevalue(record)
    steady = total * np.log10(stress / stress[0]) / np.log10(stress[-1] / stress[0])
    found = [breakage_onset(stress, stream(6, run).events(steady)) for run in range(runs)]
    assert sum(onset.stress is not None for onset in found) <= 0.1 * runs
    assert all(onset.first_break is not None for onset in found)


def test_three_lines_give_the_last_break(dense, stream):
    mean = expected(dense, rate=2000.0, early=0.0)
    mean += 40 * np.maximum(np.log10(dense / 5e4), 0)
    found = breakage_onset(dense, stream(7).events(mean))
    assert found.interval[0] <= ONSET <= found.interval[1]
    assert found.stress == pytest.approx(ONSET, rel=0.06)
    assert found.first_break < 1.2e5


@pytest.mark.parametrize("record, runs", [("stages", 30), ("dense", 8)])
def test_readings_that_fall_are_taken_with_their_noise(record, runs, stream, request):
    stress = request.getfixturevalue(record)
    covered, alarms = 0, 0
    for run in range(runs):
        noise = 0.02 * stream(8, run).normal(len(stress))
        broken = expected(stress, rate=1.0, early=0.0) + noise
        found = breakage_onset(stress, broken)
        assert (found.first_break is None) == bool((np.diff(broken) < 0).any() or broken[0] < 0)
        covered += found.interval[0] <= ONSET <= found.interval[1]
        alarms += breakage_onset(stress, noise).stress is not None
        alarms += breakage_onset(stress, np.log10(stress) + noise).stress is not None
    assert covered >= 0.85 * runs
    assert alarms <= 0.2 * runs


def test_nothing_broke(stages):
    found = breakage_onset(stages, np.zeros(10))
    assert found.stress is found.interval is found.first_break is found.rate is None
    with pytest.raises(GrusError, match="^onset = None: must be found, to have a line$"):
        found.line(1e6)


def test_one_broken_bond_is_no_onset(stages):
    found = breakage_onset(stages, [0, 0, 0, 0, 0, 0, 0, 1, 1, 1])
    assert found.stress is None
    assert found.first_break == 800e3
    assert found.first_interval == pytest.approx((700e3, 800e3))


def test_broken_from_the_first_reading_on(stages):
    found = breakage_onset(stages, 3 + np.arange(10))
    assert found.first_break == 100e3
    assert found.first_interval == (0.0, 100e3)


def test_count_and_share_agree(stages, stream):
    stress = with_start(stages)
    broken = stream(9).events(expected(stress))
    count, share = breakage_onset(stress, broken), breakage_onset(stress, broken / 2350)
    assert share.stress == pytest.approx(count.stress)
    assert share.interval == pytest.approx(count.interval)
    assert share.rate == pytest.approx(count.rate / 2350)


def test_unloading_does_not_matter(dense, stream):
    broken = stream(10).events(expected(dense))
    stress = np.concatenate([dense, dense[::-5]])
    plain = breakage_onset(dense, broken)
    assert breakage_onset(stress, np.concatenate([broken, broken[-1] + np.arange(300)])) == plain


def test_few_readings_are_refused(stages):
    message = "^readings of first loading = 6: must be at least 7$"
    with pytest.raises(GrusError, match=message):
        breakage_onset(stages[:6], np.arange(6))
