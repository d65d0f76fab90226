"""Cutting records of known programs."""

import numpy as np
import pytest
from trials import Draw

from grus.errors import GrusError
from grus.record import Record
from grus.recording import segments


def record(stress, strain=None, time=None, **others) -> Record:
    stress = np.asarray(stress, dtype=float)
    strain = np.linspace(0, 0.1, len(stress)) if strain is None else np.asarray(strain)
    channels = {"axial_stress": stress, "axial_strain": strain} | others
    units = {"axial_stress": "Pa", "axial_strain": "1"} | {name: "1" for name in others}
    if time is not None:
        channels, units = {"time": np.asarray(time, float)} | channels, {"time": "s"} | units
    return Record(channels, units)


def told(found) -> list[tuple]:
    return [(one.kind, one.stage, one.first, one.last) for one in found]


def test_seating_loads_holds_unloading_and_reloading():
    stress = 1e3 * np.concatenate(
        [
            np.full(5, 5.0),
            np.linspace(5, 100, 11)[1:],
            np.full(9, 100.0),
            np.linspace(100, 20, 9)[1:],
            np.full(4, 20.0),
            np.linspace(20, 200, 19)[1:],
            np.full(6, 200.0),
        ]
    )
    found = segments(record(stress))
    assert told(found) == [
        ("seat", 0, 0, 4),
        ("load", 1, 4, 14),
        ("hold", 2, 14, 23),
        ("unload", 3, 23, 31),
        ("hold", 4, 31, 35),
        ("reload", 5, 35, 43),
        ("load", 5, 43, 53),
        ("hold", 6, 53, 59),
    ]
    assert all(one.t0 is None and one.t1 is None for one in found)
    assert [one.stress_to for one in found] == pytest.approx(
        [5e3, 100e3, 100e3, 20e3, 20e3, 100e3, 200e3, 200e3]
    )


def test_loads_put_on_at_once_with_logarithmic_times():
    minutes = np.concatenate([[0.0], np.geomspace(0.1, 1440, 15)])
    time = 60 * np.concatenate([minutes + 1440 * i + i for i in range(4)])
    stress = 1e3 * np.repeat([10.0, 25.0, 50.0, 100.0], 16)
    found = segments(record(stress, time=time))
    assert [(one.kind, one.first, one.last) for one in found] == [
        ("hold", 0, 15),
        ("load", 15, 16),
        ("hold", 16, 31),
        ("load", 31, 32),
        ("hold", 32, 47),
        ("load", 47, 48),
        ("hold", 48, 63),
    ]
    assert (found[2].t0, found[2].t1) == (time[16], time[31])


def test_ends_of_stages_only():
    stress = 1e3 * np.array([7, 20, 45, 96, 198, 402, 198, 45, 7, 20, 96, 402, 810, 1625])
    assert [(one.kind, one.first, one.last) for one in segments(record(stress))] == [
        ("load", 0, 5),
        ("unload", 5, 8),
        ("reload", 8, 11),
        ("load", 11, 13),
    ]


def test_two_readings_of_each_stage():
    stress = 1e3 * np.repeat([10.0, 25.0, 50.0, 100.0, 50.0, 10.0], 2)
    kinds = [one.kind for one in segments(record(stress))]
    assert kinds == ["hold", *["load", "hold"] * 3, *["unload", "hold"] * 2]


def test_a_creep_test_is_one_hold():
    (one,) = segments(record(np.full(50, 1e5), time=np.arange(50)))
    assert (one.kind, one.stage, one.first, one.last) == ("hold", 1, 0, 49)


def test_a_test_at_a_constant_rate_is_one_load():
    strain = np.linspace(0, 0.1, 300)
    stress = 1e4 * np.exp(40 * strain)
    assert told(segments(record(stress, strain))) == [("load", 1, 0, 299)]


@pytest.mark.parametrize("factor", [1.0, 1e-3, 1e4])
def test_the_scale_of_stress_and_time_does_not_matter(factor):
    draw = Draw(3, 0)
    stress = 1e5 * np.repeat([1.0, 2.0, 4.0, 2.0], 40) * (1 + 0.005 * draw.gauss(160))
    plain = told(segments(record(stress, time=np.arange(160))))
    scaled = record(factor * stress, time=factor**2 * np.arange(160) + 77.0)
    assert told(segments(scaled)) == plain and len(plain) == 7


def test_overshoot_and_drift_of_a_servo_are_parts_of_the_hold():
    done = np.linspace(0, 1, 60)
    stress = 1e5 * np.concatenate(
        [np.linspace(1, 2, 40), 2 * (1 + 0.04 * np.exp(-done / 0.05) - 0.01 * done)]
    )
    found = segments(record(stress, time=np.arange(100)))
    assert [one.kind for one in found] == ["load", "hold"]
    assert abs(found[1].first - 40) <= 1 and found[1].last == 99


def test_neighbours_share_a_row_and_changes_add_up():
    draw = Draw(4, 0)
    stress = 1e5 * np.repeat([1.0, 3.0, 9.0], 30) * (1 + 0.01 * draw.gauss(90))
    whole = record(stress)
    found = segments(whole)
    assert all(before.last == after.first for before, after in zip(found, found[1:]))
    strain = whole["axial_strain"]
    changes = [strain[one.last] - strain[one.first] for one in found]
    assert sum(changes) == pytest.approx(strain[-1] - strain[0])


def test_noise_of_each_channel_in_each_segment():
    draw = Draw(5, 0)
    stress = 1e5 * np.repeat([1.0, 4.0], 200) * (1 + 0.01 * draw.gauss(400))
    strain = 1e-3 * np.repeat([1.0, 2.0], 200) + 1e-5 * draw.gauss(400)
    humidity = 0.5 + np.concatenate([np.full(200, 0.01), np.full(200, 0.04)]) * draw.gauss(400)
    found = segments(record(stress, strain, humidity=humidity))
    first, last = found[0], found[-1]
    assert first.noise["axial_stress"] == pytest.approx(1e3, rel=0.3)
    assert last.noise["axial_stress"] == pytest.approx(4e3, rel=0.3)
    assert last.noise["axial_strain"] == pytest.approx(1e-5, rel=0.3)
    assert first.noise["humidity"] == pytest.approx(0.01, rel=0.3)
    assert last.noise["humidity"] == pytest.approx(0.04, rel=0.3)


def test_a_record_longer_than_is_looked_at_point_by_point():
    draw = Draw(6, 0)
    stress = 1e5 * np.repeat([1.0, 1.5, 3.0], [7001, 9002, 8003])
    stress = stress * (1 + 0.005 * draw.gauss(len(stress)))
    found = segments(record(stress, time=np.arange(len(stress))))
    assert [(one.kind, one.first, one.last) for one in found] == [
        ("hold", 0, 7000),
        ("load", 7000, 7001),
        ("hold", 7001, 16002),
        ("load", 16002, 16003),
        ("hold", 16003, 24005),
    ]


@pytest.mark.parametrize(
    "channels, message",
    [
        ({"axial_strain": [0, 1]}, "axial_stress is missing"),
        ({"axial_stress": [1e3]}, "rows = 1; allowed: two or more"),
        ({"axial_stress": [1e3, np.nan]}, "axial_stress = nan in row 1; allowed: finite"),
        ({"axial_stress": [1e3, 2e3], "time": [1.0, 0.0]}, "time = 0 s in row 1: falls"),
        ({"axial_stress": [1e3, 2e3], "time": [1.0, np.inf]}, "time = inf in row 1"),
    ],
)
def test_what_cannot_be_cut(channels, message):
    units = {"axial_strain": "1", "axial_stress": "Pa", "time": "s"}
    bad = Record(
        {name: np.array(values, dtype=float) for name, values in channels.items()},
        {name: units[name] for name in channels},
    )
    with pytest.raises(GrusError, match=message):
        segments(bad)
