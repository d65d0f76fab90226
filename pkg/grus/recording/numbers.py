"""Cells as numbers."""

import datetime
import re
from collections.abc import Sequence
from typing import Any

import numpy as np

from grus.recording.errors import RecordingError, quoted
from grus.recording.table import Table, missing

_NUMBER = re.compile(r"[+-]?(?:[0-9]+[.,]?[0-9]*|[.,][0-9]+)(?:[eE][+-]?[0-9]{1,3})?")
_PERHAPS_THOUSANDS = re.compile(r"[+-]?[1-9][0-9]{0,2},[0-9]{3}")


def check_decimals(table: Table, indices: Sequence[int]) -> None:
    """Refuses columns in which the decimal sign is not one and the same."""
    signs: dict[str, tuple[int, str]] = {}
    plain = False
    for line, row in zip(table.lines, table.rows):
        for cell in (row[index] for index in indices):
            if isinstance(cell, str) and _NUMBER.fullmatch(cell.strip()):
                for sign in {",", "."} & set(cell):
                    signs.setdefault(sign, (line, cell.strip()))
                plain = plain or "," in cell and not _PERHAPS_THOUSANDS.fullmatch(cell.strip())
    if len(signs) == 2:
        (point_line, point), (comma_line, comma) = signs["."], signs[","]
        reason = f"{quoted(comma)} and in line {point_line} {quoted(point)}"
        raise RecordingError.of(
            table.source, f"line {comma_line}", reason, "one decimal sign in the whole file"
        )
    if "," in signs and not plain:
        line, cell = signs[","]
        raise RecordingError.of(
            table.source,
            f"line {line}",
            f"{quoted(cell)} may have a decimal comma or one between thousands",
            "decimal points, or other than three digits after a decimal comma",
        )


def numbers(table: Table, index: int) -> np.ndarray:
    """A column as numbers (n,), NaN where a reading is missing; RecordingError for anything else."""
    return np.array(
        [_number(table, line, index, row[index]) for line, row in zip(table.lines, table.rows)],
        dtype=float,
    )


def _number(table: Table, line: int, index: int, cell: Any) -> float:
    if missing(cell):
        return np.nan
    if isinstance(cell, (int, float)) and not isinstance(cell, bool):
        value = float(cell) if abs(cell) < 1e300 else np.inf
    elif isinstance(cell, str) and _NUMBER.fullmatch(cell.strip()):
        value = float(cell.strip().replace(",", "."))
    else:
        raise _refusal(table, line, index, cell, "not a number")
    if not np.isfinite(value):
        raise _refusal(table, line, index, cell, "too large for a number")
    return value


def stamps(table: Table, index: int) -> np.ndarray | None:
    """A column of dates with times as seconds (n,) since the first, NaN where one is missing; None for other columns.

    Dates are those of a spreadsheet or in ISO 8601 ("2016-08-29 06:17").
    """
    found = [_stamp(row[index]) for row in table.rows]
    first = next((stamp for stamp in found if stamp is not None), None)
    if first is None:
        return None
    seconds = np.full(len(found), np.nan)
    for place, (line, row, stamp) in enumerate(zip(table.lines, table.rows, found)):
        if missing(row[index]):
            continue
        if stamp is None or (stamp.tzinfo is None) != (first.tzinfo is None):
            raise _refusal(table, line, index, row[index], "not a date like those above")
        seconds[place] = (stamp - first).total_seconds()
    return seconds


def _stamp(cell: Any) -> datetime.datetime | None:
    if isinstance(cell, datetime.datetime):
        return cell
    if not isinstance(cell, str) or _NUMBER.fullmatch(cell.strip()):
        return None
    try:
        return datetime.datetime.fromisoformat(cell.strip())
    except ValueError:
        return None


def _refusal(table: Table, line: int, index: int, cell: Any, reason: str) -> RecordingError:
    place = f"line {line}, column {quoted(table.header[index])}"
    return RecordingError.of(table.source, place, f"{quoted(cell)} is {reason}", "a finite number")
