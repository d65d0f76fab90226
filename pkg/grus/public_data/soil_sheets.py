"""Laboratory sheets of miniSoilLAB, anonymous: oedometer tests of a fine-grained and of a granular soil."""

from datetime import datetime
from math import pi
from pathlib import Path

import numpy as np
import openpyxl

from grus.record import Record
from grus.recording import RecordingError
from grus.recording.clean import Readings, merge_stamps

KILO, MILLI = 1e3, 1e-3
_SHEET = "Tabelle"
_STRESS = {"axial_stress": "Pa", "axial_strain": "1"}
_TIMED = {"time": "s"} | _STRESS


def incremental(path: Path) -> Record:
    """Four steps of load with times and settlements; each step begins with a reading under the load before."""
    cells = _cells(path)
    height = MILLI * cells["B11"]
    stamps: list[datetime] = []
    settlement: list[float] = []
    stress: list[float] = []
    for top in (23, 39, 55, 71):
        before, after = cells[f"B{top + 2}"], cells[f"B{top + 3}"]
        times, settlements = _row(cells, top + 4), _row(cells, top + 5)
        stamps += times
        settlement += settlements
        stress += [before] + [after] * (len(times) - 1)
    readings = Readings(
        str(path),
        {
            "time": np.array([(stamp - stamps[0]).total_seconds() for stamp in stamps]),
            "axial_stress": KILO * np.array(stress),
            "axial_strain": MILLI * np.array(settlement) / height,
        },
        np.arange(len(stamps)),
        [
            "axial stress: the load that is named for each step; not measured",
            f"axial strain: settlement over a height of {1e3 * height:g} mm",
            "times to the minute: nothing is resolved within the first minute of a step",
        ],
    )
    merge_stamps(readings)
    return Record(readings.channels, _TIMED, notes=tuple(readings.notes))


def rates(path: Path) -> Record:
    """Compressed at a constant rate, unloaded and compressed again: time, force and compression."""
    cells = _cells(path)
    height, diameter = MILLI * cells["B10"], MILLI * cells["B11"]
    time, force, compression = (_column(cells, letter, 16) for letter in "ABC")
    # After both turns the clock starts from the last full interval again.
    kept = np.diff(np.maximum.accumulate(time), prepend=-1.0) > 0
    return Record(
        {
            "time": time[kept],
            "axial_stress": _stress(force, diameter)[kept],
            "axial_strain": MILLI * compression[kept] / height,
        },
        _TIMED,
        notes=(
            f"axial stress: force over the area of a diameter of {1e3 * diameter:g} mm",
            f"axial strain: compression over a height of {1e3 * height:g} mm",
            f"{int((~kept).sum())} readings dropped: their times lie before those of the readings before",
        ),
    )


def loose(path: Path) -> Record:
    """Compressed once, loose: displacement and force, without times."""
    return _compressed(_cells(path), "C8", "C9", "A", "B")


def dense(path: Path) -> Record:
    """Compressed once, dense: displacement and force, without times."""
    return _compressed(_cells(path), "H8", "H9", "F", "G")


def steps(path: Path) -> Record:
    """Table of loads and settlements at the ends of the stages: loaded, unloaded, loaded again."""
    cells = _cells(path)
    height = MILLI * cells["B11"]
    stress: list[float] = []
    settlement: list[float] = []
    for row in (18, 26, 34):
        # Each part of the table begins with the end of the part before.
        begin = 1 if stress else 0
        stress += _row(cells, row)[begin:]
        settlement += _row(cells, row + 1)[begin:]
    return Record(
        {
            "axial_stress": KILO * np.array(stress),
            "axial_strain": MILLI * np.array(settlement) / height,
        },
        _STRESS,
        notes=(
            "axial stress: the load that is named for each stage; not measured",
            f"axial strain: settlement over a height of {1e3 * height:g} mm, given to 10 µm",
        ),
    )


def _compressed(cells: dict, height: str, diameter: str, way: str, force: str) -> Record:
    tall, wide = MILLI * cells[height], MILLI * cells[diameter]
    displacement = _column(cells, way, 15)
    return Record(
        {
            "axial_stress": _stress(_column(cells, force, 15), wide),
            "axial_strain": MILLI * (displacement - displacement[0]) / tall,
        },
        _STRESS,
        notes=(
            f"axial stress: force over the area of a diameter of {1e3 * wide:g} mm",
            f"axial strain: displacement since the first reading over a height of {1e3 * tall:g} mm",
        ),
    )


def _stress(force: np.ndarray, diameter: float) -> np.ndarray:
    """Axial stress [Pa] of forces [kN] on a circle."""
    return KILO * force / (pi * diameter**2 / 4)


def _cells(path: Path) -> dict:
    """Cells of the sheet by their places."""
    try:
        sheet = openpyxl.load_workbook(path, data_only=True)[_SHEET]
    except Exception as error:  # of many kinds: from the archive, the XML, or openpyxl
        reason = f"not a readable spreadsheet ({type(error).__name__})"
        raise RecordingError.of(str(path), "", reason, f"xlsx with a sheet {_SHEET}") from error
    return {cell.coordinate: cell.value for row in sheet.iter_rows() for cell in row}


def _row(cells: dict, row: int) -> list:
    """What stands in a row from column B on, up to the first empty cell or text."""
    found = []
    for letter in "BCDEFGHIJKLMNOPQRSTUVWXYZ":
        value = cells.get(f"{letter}{row}")
        if value is None or isinstance(value, str):
            break
        found.append(value)
    return found


def _column(cells: dict, letter: str, row: int) -> np.ndarray:
    """Numbers in a column from a row on, up to the first empty cell."""
    found: list[float] = []
    while cells.get(f"{letter}{row}") is not None:
        found.append(cells[f"{letter}{row}"])
        row += 1
    return np.array(found, dtype=float)
