"""The real recordings: what is read from the files, and how they are cut."""

import hashlib

import numpy as np
import pytest

from grus.errors import GrusError
from grus.public_data import DATASETS, load
from grus.public_data.ice_powder import read_columns
from grus.recording import read, segments, write
from grus.recording.events import find_jumps


def kinds(found) -> list[str]:
    return [one.kind for one in found]


@pytest.mark.parametrize("name", DATASETS)
def test_every_recording_is_read_and_cut(name, shared, tmp_path):
    record = load(name, shared)
    assert record["axial_stress"].max() > 1e4 and np.ptp(record["axial_strain"]) > 1e-3
    if "time" in record.channels:
        assert (np.diff(record["time"]) >= 0).all()
    found = segments(record)
    assert found[0].first == 0 and found[-1].last == len(record) - 1
    again = read(write(record, tmp_path / "recording.csv"))
    np.testing.assert_allclose(again["axial_stress"], record["axial_stress"], rtol=1e-12)


def test_files_are_those_of_the_catalogue(shared):
    for one in DATASETS.values():
        content = (shared / one.key).read_bytes()
        assert hashlib.sha256(content).hexdigest() == one.sha256


def test_glass_beads_are_loaded_and_unloaded_twice_without_times(shared):
    record = load("glass-beads", shared)
    assert "time" not in record.channels and len(record) == 101
    assert record["axial_stress"][0] == pytest.approx(6.781e6, rel=1e-3)
    difference = record["axial_stress"] - record["lateral_stress"]
    assert difference[0] == pytest.approx(1.79062e6)
    found = segments(record)
    assert kinds(found) == ["load", "hold", "unload", "hold", "reload", "hold", "unload"]
    stresses = [one.stress_to / 1e6 for one in found]
    assert stresses == pytest.approx([52.1, 52.1, 27.4, 27.4, 52.0, 52.0, 20.8], abs=0.1)


@pytest.mark.parametrize(
    "number, loads",
    [
        (2, [0.973, 1.16, 0.753, 0.878]),
        (3, [0.377, 0.251]),
        (4, [0.5967]),
        (5, [1.16, 0.44]),
        (6, [1.16, 0.47, 0.72, 0.59]),
        (7, [1.16]),
    ],
)
def test_ice_powder_is_held_at_the_loads_that_are_known(shared, number, loads):
    record = load(f"ice-{number:02d}", shared)
    found = segments(record)
    holds = [one for one in found if one.kind == "hold"]
    assert [one.stress_to / 1e6 for one in holds] == pytest.approx(loads)
    between = ["load" if b > a else "unload" for a, b in zip(loads, loads[1:])]
    moves = [one.kind.replace("re", "") for one in found if one.kind != "hold"]
    assert moves == between
    for one in holds:
        strain, time = record["axial_strain"][one.rows], record["time"][one.rows]
        creep = np.polyfit(time, strain, 1)[0]
        assert creep > 0 or one.stress_to < 0.8e6  # unloaded, it may swell


def test_jumps_of_ice_powder_at_steps_of_load(shared):
    table = read_columns(shared / DATASETS["ice-06"].key)
    hours = table[:, 1] / 3600
    found = [hours[first] for first, _ in find_jumps(table[:, 5], table[:, 1])]
    # The recording goes on when the load is changed: the script names a step between 136 and 140 h.
    assert len(found) == 2 and 136 < found[1] < 140


def test_increments_of_a_soil(shared):
    record = load("soil-increments", shared)
    found = segments(record)
    assert kinds(found) == ["load", "hold"] * 4
    holds = [one for one in found if one.kind == "hold"]
    assert [one.stress_to / 1e3 for one in holds] == pytest.approx([23.2, 48.7, 99.7, 201.7])
    assert all(20 * 3600 < one.t1 - one.t0 < 30 * 3600 for one in holds)
    assert record["axial_strain"][-1] == pytest.approx(0.432 / 20)


def test_constant_rates_of_a_soil(shared):
    record = load("soil-rates", shared)
    found = segments(record)
    assert found[0].kind == "seat"
    (unload,) = [one for one in found if one.kind == "unload" and one.last - one.first > 10]
    after = found[found.index(unload) + 1 :]
    assert kinds(after) == ["reload", "load"]
    assert unload.t0 / 3600 == pytest.approx(21.75, abs=0.2)
    assert unload.t1 / 3600 == pytest.approx(24.4, abs=0.2)
    strain = record["axial_strain"]
    assert strain[unload.last] < strain[unload.first]


@pytest.mark.parametrize("name", ["soil-loose", "soil-dense"])
def test_a_soil_compressed_once_is_one_load(shared, name):
    assert kinds(segments(load(name, shared))) == ["load"]


def test_ends_of_stages_of_a_soil(shared):
    record = load("soil-steps", shared)
    found = segments(record)
    assert kinds(found) == ["load", "unload", "reload", "load"]
    assert found[2].stress_to == pytest.approx(402.3e3)


@pytest.mark.parametrize("name", ["glass-beads", "ice-02", "soil-rates"])
def test_a_file_that_is_none_is_refused(tmp_path, name):
    path = tmp_path / "file"
    path.write_text("1,2,x\n")
    with pytest.raises(GrusError, match=f"{path}: "):
        DATASETS[name].convert(path)
