"""Segments and notes of a record."""

import json

import h5py
import numpy as np
import pytest

from grus.errors import GrusError
from grus.record import Record, Segment

LOAD = Segment("load", 1, 0, 2, 0.0, 20.0, 1e3, 2e3, {"axial_stress": 5.0})
HOLD = Segment("hold", 2, 2, 3, None, None, 2e3, 2e3)


def record(**others) -> Record:
    channels = {"time": np.arange(4.0), "axial_stress": np.array([1e3, 1.5e3, 2e3, 2e3])}
    return Record(channels, {"time": "s", "axial_stress": "Pa"}, **others)


def test_round_trip_with_segments_and_notes(tmp_path):
    written = record(segments=(LOAD, HOLD), notes=("two lines dropped", "µ"))
    with h5py.File(tmp_path / "r.h5", "w") as file:
        written.write(file.create_group("record"))
    with h5py.File(tmp_path / "r.h5") as file:
        again = Record.read(file["record"])
    assert again.segments == written.segments and again.notes == written.notes
    assert list(again.channels) == ["time", "axial_stress"]


def test_a_record_of_an_older_file_has_none(tmp_path):
    with h5py.File(tmp_path / "r.h5", "w") as file:
        record().write(file.create_group("record"))
        assert sorted(file["record"]) == ["axial_stress", "time"]
        assert Record.read(file["record"]).segments == ()


def test_rows_index_a_channel():
    assert list(record()["axial_stress"][LOAD.rows]) == [1e3, 1.5e3, 2e3]


def test_segment_goes_through_json():
    assert Segment(**json.loads(json.dumps(LOAD.to_dict()))) == LOAD


@pytest.mark.parametrize(
    "change, message",
    [
        ({"kind": "creep"}, "kind = 'creep'; allowed: seat, load, reload, unload, hold, event"),
        ({"first": 3, "last": 2}, "rows = 3 to 2; allowed: 0 or more, in order"),
        ({"first": -1}, "rows = -1 to 2"),
    ],
)
def test_bad_segments_are_refused(change, message):
    with pytest.raises(GrusError, match=message):
        Segment(**(LOAD.to_dict() | change))


def test_segments_beyond_the_rows_are_refused():
    with pytest.raises(GrusError, match="segments: end at row 9; allowed: below 4"):
        record(segments=(Segment("hold", 1, 0, 9, None, None, 1.0, 1.0),))
