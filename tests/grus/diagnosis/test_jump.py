"""The jump of strain at constant stress that may be a collapse."""

from dataclasses import replace

import pytest
from formula import made_test

from grus.diagnosis.jump import largest_jump
from grus.diagnosis.layout import layout
from grus.diagnosis.protocol import protocol


def with_jump(record, size: float, share: float, stage: int = 3):
    """The record with a jump in the hold that is segment `stage`."""
    hold = record.segments[stage]
    moment = hold.t0 + share * (hold.t1 - hold.t0)
    strain = record["axial_strain"] + size * (record["time"] > moment)
    return replace(record, channels=record.channels | {"axial_strain": strain})


@pytest.mark.parametrize("share", [0.2, 0.5, 0.8])
def test_jump_is_found_where_it_is(share):
    record = with_jump(made_test(noise=3e-6, creep=2e-5), 2e-4, share)
    found = largest_jump(record, record.segments)
    assert found.stage == 3 and found.before <= share <= found.after
    assert found.strain == pytest.approx(2e-4, rel=0.15)


@pytest.mark.parametrize("effect", [{}, {"creep": 2e-4}, {"drift": 3e-9}])
@pytest.mark.parametrize("seed", range(5))
def test_noise_creep_and_drift_are_no_jump(effect, seed):
    record = made_test(noise=3e-6, seed=seed, **effect)
    assert largest_jump(record, record.segments) is None


def test_of_two_the_larger_counts():
    record = with_jump(with_jump(made_test(noise=2e-6), 1e-4, 0.5, stage=1), 3e-4, 0.4)
    assert largest_jump(record, record.segments).stage == 3


def test_it_is_a_cell_of_its_own():
    record = with_jump(made_test(noise=2e-6), 2e-4, 0.5)
    plan = protocol(record)
    view = layout(record, plan)
    own = [
        view.measured[i]
        for i, e in enumerate(view.entries)
        if (e.stage, e.start, e.end) == (3, plan.jump.before, plan.jump.after)
    ]
    assert own == [pytest.approx(2e-4, rel=0.1)]


def test_a_recording_without_times_has_jumps_too():
    record = with_jump(made_test(noise=2e-6), 2e-4, 0.5)
    channels = {name: values for name, values in record.channels.items() if name != "time"}
    units = {name: unit for name, unit in record.units.items() if name != "time"}
    segments = tuple(replace(s, t0=None, t1=None) for s in record.segments)
    untimed = replace(record, channels=channels, units=units, segments=segments)
    assert largest_jump(untimed, untimed.segments).strain == pytest.approx(2e-4, rel=0.2)


def test_a_jump_in_a_long_recording_is_found():
    record = with_jump(made_test(noise=2e-6, rows=3000), 2e-4, 0.5)
    found = largest_jump(record, record.segments)
    assert found.stage == 3 and found.strain == pytest.approx(2e-4, rel=0.15)
    assert 0.3 < found.before < found.after < 0.7
