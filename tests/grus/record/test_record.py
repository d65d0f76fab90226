"""The table of a test."""

import h5py
import numpy as np
import pytest

from grus.errors import GrusError
from grus.record import Record


def record() -> Record:
    return Record(
        {"time": np.array([0.0, 0.1, 0.3]), "force": np.array([1.0, np.nan, 3.0])},
        {"time": "s", "force": "N"},
        {"test": "crushing", "seed": 3},
    )


def test_channels_by_name_and_length():
    assert len(record()) == 3 and record()["time"][1] == 0.1


def test_headers_carry_units():
    assert list(record().frame().columns) == ["time [s]", "force [N]"]


def test_round_trip_is_exact(tmp_path):
    with h5py.File(tmp_path / "r.h5", "w") as file:
        record().write(file.create_group("record"))
    with h5py.File(tmp_path / "r.h5") as file:
        again = Record.read(file["record"])
    assert list(again.channels) == ["time", "force"]
    assert again.units == record().units and again.meta == record().meta
    for name, values in record().channels.items():
        np.testing.assert_array_equal(again[name], values)


@pytest.mark.parametrize(
    "channels, units, message",
    [
        ({"a": [1, 2], "b": [1]}, {"a": "s", "b": "N"}, "lengths differ"),
        ({"a": [1, 2]}, {}, "every channel needs one unit"),
        ({"a": [1, 2]}, {"a": "s", "b": "N"}, "every channel needs one unit"),
    ],
)
def test_bad_tables_are_refused(channels, units, message):
    with pytest.raises(GrusError, match=message):
        Record(channels, units)
