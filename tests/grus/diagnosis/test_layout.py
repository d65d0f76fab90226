"""What is compared: cells, ratios, and the same of a simulation."""

from dataclasses import replace

import numpy as np
import pytest
from formula import HOUR, compared, made_test

from grus.diagnosis.layout import LOWEST, layout
from grus.diagnosis.protocol import protocol
from grus.diagnosis.simulator import rescaled, retimed
from grus.errors import GrusError
from grus.record import Record


def test_stages_follow_the_segments():
    plan = protocol(made_test())
    assert [s.split(" in ")[0].split(" for ")[0] for s in plan.stages] == [
        "load to 200000 Pa",
        "hold",
        "load to 500000 Pa",
        "hold",
        "unload to 50000 Pa",
    ]
    assert [s.kind for s in plan.segments] == ["load", "hold", "load", "hold", "unload"]
    assert plan.highest == 500e3 and plan.timed


def test_times_and_stresses_are_rounded_so_that_like_tests_share_their_runs():
    one = made_test()
    time = one["time"] * 1.02
    other = replace(
        one,
        channels=one.channels | {"time": time},
        segments=tuple(
            replace(s, t0=s.t0 * 1.02, t1=s.t1 * 1.02, stress_to=s.stress_to * 1.002)
            for s in one.segments
        ),
    )
    assert protocol(one).stages == protocol(other).stages


def test_a_test_that_never_loads_is_refused():
    record = made_test()
    unloaded = replace(record, segments=record.segments[-1:])
    with pytest.raises(GrusError, match="never rises"):
        protocol(unloaded)


def test_changes_add_up_to_the_strain_of_each_stage():
    record = made_test(creep=1e-4)
    view = compared(record)
    for stage, segment in list(enumerate(view.protocol.segments))[1:]:
        whole = record["axial_strain"][segment.last] - record["axial_strain"][segment.first]
        own = view.where(stage=stage, channel="strain")
        assert view.measured[own].sum() == pytest.approx(whole, rel=0.02, abs=2e-6)


def test_nothing_is_compared_under_little_stress():
    view = compared(made_test())
    own = view.where(stage=0, channel="strain")
    least = LOWEST * 500e3
    assert [e.start for e, o in zip(view.entries, own) if o][0] == least
    assert view.measured[own].sum() == pytest.approx((200e3 - least) / 3e8, rel=0.02)


def test_a_simulation_that_equals_the_recording_differs_by_nothing():
    record = made_test(creep=1e-4, base=0.9)
    view = compared(record)
    simulated = replace(record, segments=tuple(replace(s) for s in record.segments))
    assert np.allclose(view.of(simulated), view.measured, atol=1e-9)


def test_noise_of_changes_is_that_of_repeated_recordings():
    views = [compared(made_test(noise=1e-5, seed=seed)) for seed in range(300)]
    seen = np.cov(np.array([view.measured for view in views]).T)
    stated = views[0].noise
    assert np.sqrt(np.diag(seen)) == pytest.approx(np.sqrt(np.diag(stated)), rel=0.2)


def test_holds_without_times_have_one_cell():
    record = made_test(creep=1e-4)
    channels = {n: v for n, v in record.channels.items() if n != "time"}
    units = {n: u for n, u in record.units.items() if n != "time"}
    cut = tuple(replace(s, t0=None, t1=None) for s in record.segments)
    view = compared(Record(channels, units, record.meta, cut))
    assert view.where(kind="hold", channel="strain").sum() == 2


def test_ratio_of_base_to_top_is_read_at_the_end_of_each_stage():
    view = compared(made_test(base=0.9))
    own = view.where(channel="base")
    assert own.sum() == 5
    assert view.measured[own] == pytest.approx(np.log(0.9), abs=1e-6)


def test_a_stiffer_scale_leaves_ratios_alone():
    view = compared(made_test(base=0.9))
    double = view.stiffened(2.0)
    strain = view.where(channel="strain")
    assert double.measured[strain] == pytest.approx(2 * view.measured[strain])
    assert double.measured[~strain] == pytest.approx(view.measured[~strain])


def test_a_load_beyond_the_highest_stress_before_is_one_stage_here():
    record = made_test()
    first, *rest = record.segments
    middle = (first.first + first.last) // 2
    split = (
        replace(first, kind="reload", last=middle, t1=HOUR / 2, stress_to=100e3),
        replace(first, first=middle, t0=HOUR / 2, stress_from=100e3),
    )
    view = layout(record, protocol(record))
    assert np.allclose(view.of(replace(record, segments=(*split, *rest))), view.measured, atol=1e-9)


def test_a_stress_that_is_reached_again_is_the_same_stage():
    """A reading comes just below or above it."""
    record = made_test()
    last = record.segments[-1]
    again = replace(last, kind="reload", stage=6, stress_from=50e3, stress_to=480e3)
    plan = protocol(replace(record, segments=(*record.segments, again)))
    assert plan.stages[-1].startswith("load to 500000 Pa")


def test_the_program_states_stresses():
    record = made_test()
    program = [
        "load to 205 kPa",
        "hold for 24 h",
        "load to 510 kPa",
        "hold for 24 h",
        "unload to 52 kPa",
    ]
    assert [s.split()[2] for s in protocol(record, program).stages if "hold" not in s] == [
        "205000",
        "510000",
        "52000",
    ]


def test_without_the_clock_tests_of_the_same_stresses_are_one():
    one = made_test()
    other = replace(
        one,
        channels=one.channels | {"time": 7 * one["time"]},
        segments=tuple(replace(s, t0=7 * s.t0, t1=7 * s.t1) for s in one.segments),
    )
    plans = protocol(one), protocol(other)
    assert plans[0].stages != plans[1].stages and plans[0].timeless == plans[1].timeless


def test_a_simulation_has_the_times_of_the_recording():
    """All its stages take an hour; those of the recording an hour or a day."""
    recorded = made_test()
    hours = tuple(
        replace(s, t0=HOUR * k, t1=HOUR * (k + 1)) for k, s in enumerate(recorded.segments)
    )
    time = np.interp(
        recorded["time"],
        [recorded.segments[0].t0, *(s.t1 for s in recorded.segments)],
        HOUR * np.arange(6),
    )
    seated = tuple(replace(s, stage=s.stage) for s in hours)
    simulated = replace(recorded, channels=recorded.channels | {"time": time}, segments=seated)
    shown = retimed(simulated, protocol(recorded), wetted=False)
    assert shown["time"] == pytest.approx(recorded["time"], abs=1e-6)
    assert [s.t1 for s in shown.segments] == pytest.approx([s.t1 for s in recorded.segments])


def test_stresses_far_from_those_of_the_small_model_are_scaled():
    """By a power of ten, so that rockfill under 50 MPa has the program of rockfill under 500 kPa."""
    one = made_test()
    strong = rescaled(one, 100.0)
    plan = protocol(strong)
    assert plan.scale == 0.01 and plan.stages == protocol(one).stages
    assert plan.highest == 100 * protocol(one).highest and protocol(one).scale == 1
    weak = rescaled(one, 0.1)
    assert protocol(weak).scale == 10


def test_a_scaled_simulation_has_the_stresses_of_the_recording():
    strong = rescaled(made_test(), 100.0)
    view = compared(strong)
    assert view.of(rescaled(made_test(), 100.0)) == pytest.approx(view.measured, abs=1e-12)
    assert np.array_equal(strong["axial_strain"], made_test()["axial_strain"])


def test_acoustic_events_are_shared_by_holds():
    record = made_test()
    heard = np.interp(
        record["time"], [0, HOUR, 25 * HOUR, 26 * HOUR, 50 * HOUR], [0, 10, 20, 60, 100]
    )
    record = replace(
        record,
        channels=record.channels | {"ae_events": heard},
        units=record.units | {"ae_events": "1"},
    )
    view = compared(record)
    own = view.where(channel="events")
    assert view.measured[own] == pytest.approx([0.1, 0.4], abs=0.01)
    few = replace(record, channels=record.channels | {"ae_events": heard / 20})
    assert not compared(few).events
