"""What is written is a recording that is read again."""

import numpy as np
import pytest

from grus.record import Record
from grus.recording import read, write


def test_round_trip(tmp_path):
    record = Record(
        {
            "time": np.array([0.0, 0.1, 1 / 3]),
            "axial_stress": np.array([1e3, 2.5e5, 1e6 / 3]),
            "axial_strain": np.array([0.0, 1e-7, 0.1]),
            "temperature": np.array([293.15, np.nan, 294.0]),
        },
        {"time": "s", "axial_stress": "Pa", "axial_strain": "1", "temperature": "K"},
        {"source": "a test", "height": 0.02},
        notes=("two lines\ndropped",),
    )
    path = write(record, tmp_path / "recording.csv")
    again = read(path)
    assert again.units == record.units and again.meta["height"] == 0.02
    for name, values in record.channels.items():
        assert again[name] == pytest.approx(values, rel=1e-15, nan_ok=True)
    assert "# two lines\\ndropped\n" in path.read_text()
