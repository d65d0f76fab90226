"""Tests with laboratory time: holds, ageing and wetting, what a laboratory writes down, and going on in mid-hold."""

import numpy as np
import pytest
from test_oedometer_resume import assert_same

import grus.oedometer.clock as clock
from grus.mechanisms import MECHANISMS
from grus.oedometer import Analysis, OedometerTest, laboratory, oedometer, write_report
from grus.oedometer.program import has_clock, program
from grus.oedometer.test import servo
from grus.recording import read, segments

STAGES = [
    "load to 100 kPa in 1 h",
    "hold for 24 h",
    "wet",
    "load to 200 kPa",
    "hold for 24 h",
    "unload to 50 kPa in 1 h",
    "hold for 24 h",
    "load to 250 kPa in 1 h",
]
AGEING = {"exponent": 20, "reference_time": "100 s"}
HOUR = 3600.0


@pytest.fixture(scope="module")
def aged(plane):
    return plane.with_overrides(
        {"oedometer.stages": STAGES, "ageing": AGEING, "wetting.strength_factor": 0.8}
    )


@pytest.fixture(scope="module")
def aged_result(aged, tmp_path_factory, specimens):
    return oedometer(aged, tmp_path_factory.mktemp("aged"), specimens=specimens)


@pytest.fixture(scope="module")
def plain_result(plane, tmp_path_factory, specimens):
    """The same stages with bonds that time does nothing to."""
    stages = [stage for stage in STAGES if stage != "wet"]
    card = plane.with_overrides({"oedometer.stages": stages})
    return oedometer(card, tmp_path_factory.mktemp("plain"), specimens=specimens)


@pytest.fixture(scope="module")
def record(aged_result):
    return laboratory(aged_result)


def of_stage(record, number: int):
    """The segment of a stage."""
    return first_of(record.segments, number)


def first_of(segments, number: int):
    return next(one for one in segments if one.stage == number)


def test_the_clock_of_the_program(aged):
    plan = program(aged)
    assert [one.begins for one in plan[1:4]] == [0, HOUR, 25 * HOUR]
    assert plan[-1].ends == 75 * HOUR + 60 and has_clock(plan)
    assert [one.name for one in plan[2:4]] == ["hold at 100 kPa", "wet at 100 kPa"]


def test_stages_and_clock_of_the_engine_agree(aged_result):
    rests, plan = aged_result.rests, program(aged_result.card)
    for number, stage in enumerate(plan):
        own = rests["clock"][rests["stage"] == number]
        if stage.kind == "hold":
            assert (own[0], own[-1]) == (stage.begins, stage.ends)
        assert ((own >= stage.begins) & (own <= stage.ends)).all()
    assert (np.diff(rests["clock"]) >= 0).all()


def test_bonds_fail_in_holds_under_load(aged_result, plain_result):
    for number in (2, 5):
        before, after = aged_result.stages[number - 1 : number + 1]
        assert after.breaks > before.breaks and after.height < before.height
    before, after = aged_result.stages[6:8]
    assert after.breaks == before.breaks  # creep stops after unloading
    assert aged_result.rests["failures"][-1] > 0
    assert len(plain_result.rests) == 0


def test_a_hold_without_ageing_is_flat(plain_result):
    """All that breaks has broken before its clock goes on."""
    record = laboratory(plain_result)
    for one in record.segments:
        if one.kind == "hold":
            assert np.ptp(record["axial_strain"][one.rows]) == 0
            assert np.ptp(record["ae_events"][one.rows]) == 0
            assert one.t1 - one.t0 == 24 * HOUR


def test_every_hold_begins_quiet(plain_result):
    """Three stretches of rest, though no bond breaks."""
    steps = [end.steps for end in plain_result.stages]
    quiet = plain_result.card.oedometer.quiet_steps
    assert steps[6] - steps[5] >= 3 * quiet


def test_energy_balance_stays_closed(aged_result):
    assert abs(aged_result.energy_error[-1]) < 0.01


def test_record_is_one_of_a_laboratory(record, aged_result):
    assert list(record.channels) == list(record.units)
    assert record.units["time"] == "s" and record.units["axial_stress"] == "Pa"
    assert record["axial_strain"][0] == 0 and record["time"][0] == 0
    assert (np.diff(record["time"]) >= 0).all() and (np.diff(record["ae_events"]) >= 0).all()
    last = aged_result.stages[-1]
    assert record["axial_strain"][-1] == 1 - last.height / record.meta["height"]
    assert record["ae_events"][-1] == last.breaks
    assert record["time"][-1] == 75 * HOUR + 60
    assert {record.meta["model"], record.meta["seed"]} == {"plane", aged_result.card.seed}


def test_segments_are_the_stages_and_share_their_rows(record):
    parts = [one for one in record.segments if one.kind != "event"]
    assert [(one.kind, one.stage) for one in parts] == [
        ("seat", 0),
        ("load", 1),
        ("hold", 2),
        ("hold", 3),
        ("load", 4),
        ("hold", 5),
        ("unload", 6),
        ("hold", 7),
        ("reload", 8),
        ("load", 8),
    ]
    for one, after in zip(parts, parts[1:]):
        assert one.last == after.first
    assert parts[-1].last == len(record) - 1
    (event,) = (one for one in record.segments if one.kind == "event")
    assert event.stage == 3 and event.rows == of_stage(record, 3).rows
    assert (
        record["axial_stress"][parts[-2].last]
        <= 200e3
        < record["axial_stress"][parts[-1].first + 1]
    )


def test_stress_rises_with_time_in_a_load(record):
    own = record["axial_stress"][of_stage(record, 1).rows]
    assert (np.diff(own) > 0)[:-1].all() and len(own) > 20
    # at once: its end only
    assert of_stage(record, 4).last - of_stage(record, 4).first == 1


def test_holds_are_read_at_logarithmic_times(record, plain_result):
    for one in (of_stage(record, 2), of_stage(laboratory(plain_result), 2)):
        assert one.last - one.first >= 50


def test_recording_is_read_back(record, aged_result, tmp_path):
    found = write_report(aged_result, tmp_path)
    assert "recording.csv" in found["files"]
    assert found["laboratory"]["time"] == 75 * HOUR + 60
    again = read(tmp_path / "recording.csv")
    assert len(again) == len(record) and again.meta["height"] == record.meta["height"]
    for name in record.channels:
        np.testing.assert_allclose(again[name], record[name], rtol=1e-12, err_msg=name)
    # Told from the readings alone the stages are the same; a single reading is no seating.
    cut = segments(again, aged_result.card.oedometer.stages)
    assert {one.stage for one in cut} == set(range(1, 9))
    for stage in range(2, 8):
        whole, told = of_stage(record, stage), first_of(cut, stage)
        assert told.kind == whole.kind and abs(told.first - whole.first) <= 1


def test_program_without_time_gives_a_record_without_one(plane_result):
    record = laboratory(plane_result)
    assert "time" not in record.channels and len(record) > 50
    assert [(one.kind, one.stage) for one in record.segments] == [
        ("seat", 0),
        ("load", 1),
        ("load", 2),
        ("unload", 3),
    ]


@pytest.mark.parametrize("stage", [2, 5])
def test_interrupted_in_mid_hold(aged, aged_result, tmp_path, specimens, monkeypatch, stage):
    """Bit by bit the same as without the interruption."""
    monkeypatch.setattr("grus.oedometer.slices.LOOK", 0.0)

    def tell(share: float, line: str) -> None:
        engine = clock.ageing()
        if share > 0 and servo().stage == stage and engine.holding:
            if engine.clock > program(aged)[stage].begins:
                raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt, match=f"interrupted in stage {stage}, hold at"):
        oedometer(aged, tmp_path, tell, specimens)
    again = oedometer(aged, tmp_path, specimens=specimens)
    assert_same(aged_result, again)
    for name, values in aged_result.rests.channels.items():
        np.testing.assert_array_equal(values, again.rests[name], err_msg=name)


def test_wetting_at_a_time(aged, tmp_path, specimens):
    """The strengths fall in the middle of the hold, and nothing happens before when bonds do not age."""
    card = aged.with_overrides(
        {"ageing": None, "oedometer.stages": ["load to 200 kPa", "hold for 4 h"]}
        | {"wetting": {"strength_factor": 0.6, "time": "1 h"}}
    )
    record = laboratory(oedometer(card, tmp_path, specimens=specimens))
    hold = of_stage(record, 2).rows
    time, events, strain = (record[name][hold] for name in ("time", "ae_events", "axial_strain"))
    dry = time < HOUR
    assert np.ptp(events[dry]) == 0 and np.ptp(strain[dry]) == 0
    assert events[~dry].min() > events[0] and strain[~dry].min() > strain[0]
    assert np.ptp(events[~dry]) == 0


def test_fixed_base_under_friction(plane, tmp_path, specimens):
    """The ring carries what the base does not get."""
    rough = MECHANISMS["wall_friction"].apply(plane, {"coefficient": 0.3})
    rough = rough.with_overrides({"oedometer.stages": ["load to 60 kPa", "unload to 5 kPa"]})
    result = oedometer(rough, tmp_path, specimens=specimens)
    record = laboratory(result)
    loaded, unloaded = (one.last for one in record.segments[1:])
    assert record["axial_stress"][[loaded, unloaded]] == pytest.approx([60e3, 5e3], rel=0.01)
    assert record["base_stress"][loaded] < 0.97 * record["axial_stress"][loaded]
    assert record["base_stress"][unloaded] > record["axial_stress"][unloaded]
    assert abs(result.energy_error[-1]) < 0.01


def test_record_of_a_test_in_the_scene(plane, specimens):
    """A script that runs the stages itself gets the record of what has been run."""
    from yade import O

    from grus.oedometer.run import begin
    from grus.preparation import prepare

    card = plane.with_overrides({"oedometer.stages": ["load to 40 kPa in 1 h", "hold for 1 h"]})
    test = OedometerTest(card, prepare(card, specimens))
    for stage in program(card)[:2]:
        begin(card, stage)
        O.run(-1, True)
    record = laboratory(test)
    assert record["time"][-1] == HOUR
    assert [one.kind for one in record.segments] == ["seat", "load"]


@pytest.mark.parametrize(
    "name, value",
    [("strength_scatter", 0.3), ("loading_too_fast", 0.5), ("wall_friction", 0.15)],
)
def test_energy_balance_stays_closed_with_each_mechanism(plane, tmp_path, specimens, name, value):
    """At the end of each stage."""
    mechanism = MECHANISMS[name]
    plain = plane.with_overrides({"bond.scatter": None, "oedometer.stages": ["load to 200 kPa"]})
    card = mechanism.apply(plain, {mechanism.parameters[0].name: value})
    result = oedometer(card, tmp_path, specimens=specimens)
    assert abs(result.energy_error[Analysis.of(result).rows]).max() < 0.01
