"""Jumps of strain inside a segment."""

import numpy as np
import pytest
from test_segments import record
from trials import Draw

from grus.recording import segments
from grus.recording.events import find_jumps

NOISE = 1e-5


def creep(number: int, count: int = 200) -> np.ndarray:
    """Strain in a hold: fast at first, then slower and slower."""
    time = np.arange(count)
    return 2e-3 * np.log1p(time / 5) + NOISE * Draw(21, number).gauss(count)


@pytest.mark.parametrize("intervals", [1, 2, 4])
@pytest.mark.parametrize("number", range(20))
def test_a_jump_in_a_hold(number, intervals):
    strain, at = creep(number), 40 + 7 * number
    strain += 1e-3 * np.clip((np.arange(200) - at) / intervals, 0, 1)
    ((first, last),) = find_jumps(strain, np.arange(200.0))
    assert first <= at + 1 and last >= at + intervals - 1
    assert at - 4 <= first and last <= at + intervals + 4


def test_small_jumps_are_found_when_they_are_ten_times_the_noise():
    time = np.arange(200.0)
    found = 0
    for number in range(50):
        strain = 1e-4 * np.log1p(time / 5) + NOISE * Draw(23, number).gauss(200)
        strain += 10 * NOISE * (time >= 40 + number)
        found += [first for first, _ in find_jumps(strain, time)] == [39 + number]
    assert found >= 48


@pytest.mark.parametrize("number", range(20))
def test_creep_has_none(number):
    assert find_jumps(creep(number), np.arange(200.0)) == []


def test_the_beginning_of_a_hold_is_none():
    time = np.concatenate([[0.0], np.geomspace(1e-3, 1e3, 60)])
    strain = 0.01 * np.log1p(1e4 * time) / 10
    assert find_jumps(strain, time) == []


def test_a_gap_in_time_is_none():
    time = np.concatenate([np.arange(50.0), np.arange(90.0, 140.0)])
    strain = 1e-4 * time + NOISE * Draw(22, 0).gauss(100)
    assert find_jumps(strain, time) == []


def test_a_jump_while_loading_is_an_event_of_its_stage():
    stress = np.linspace(1e5, 1e6, 120)
    strain = 0.02 * np.log(stress / 1e5) + 5e-3 * (stress > 5e5)
    load, event = segments(record(stress, strain))
    assert (load.kind, load.first, load.last) == ("load", 0, 119)
    assert event.kind == "event" and event.stage == load.stage
    assert stress[event.first] <= 5e5 < stress[event.last] and event.last - event.first <= 2
    assert event.stress_from == pytest.approx(stress[event.first], rel=0.02)


def test_two_jumps():
    strain = creep(0, 300)
    strain[100:] += 1e-3
    strain[220:] -= 1e-3
    assert [first for first, _ in find_jumps(strain, np.arange(300.0))] == [99, 219]
