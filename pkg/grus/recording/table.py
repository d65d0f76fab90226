"""The cells of a recording as they stand in the file."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from grus.recording.errors import RecordingError, quoted

MISSING = {"", "-", "--", "nan", "na", "n/a", "null", "none"}
MISSING |= {"#n/a", "#na", "#div/0!", "#value!", "#ref!", "#num!", "#name?", "#null!"}
"""What stands for a reading that is missing, in small letters."""
MOST_COMMENTS, LONGEST = 50, 300
"""Comments that are kept, and characters of each."""


@dataclass(frozen=True)
class Table:
    """Header and rows of cells, each row as long as the header, with its line or row number in the file.

    comments: `key = value` of the comment lines. notes: what was done to read the file.
    """

    source: str
    header: list[str]
    rows: list[list[Any]]
    lines: list[int]
    comments: dict[str, str]
    notes: tuple[str, ...] = ()


def missing(cell: Any) -> bool:
    """Whether a cell holds no reading."""
    return cell is None or isinstance(cell, str) and cell.strip().casefold() in MISSING


def table_of(source: str, lines: Iterable[tuple[int, list[Any]]], hint: str = "") -> Table:
    """The table in numbered lines of cells: comments begin with #, and the first other line is the header.

    hint: what may be wrong when a line has more cells than the header.
    """
    header: list[str] = []
    comments: dict[str, str] = {}
    rows, numbers = [], []
    for number, cells in lines:
        if all(missing(cell) for cell in cells):
            continue
        first = next(cell for cell in cells if cell not in (None, ""))
        if isinstance(first, str) and first.lstrip().startswith("#") and not missing(first):
            text = " ".join(str(cell) for cell in cells if cell not in (None, ""))
            name, equals, value = text.lstrip("# \t").partition("=")
            if equals and len(comments) < MOST_COMMENTS:
                comments[name.strip()[:LONGEST]] = value.strip()[:LONGEST]
        elif not header:
            header = ["" if cell is None else str(cell).strip() for cell in cells]
        else:
            rows.append(_fitted(source, number, cells, len(header), hint))
            numbers.append(number)
    if not header:
        raise RecordingError.of(source, "", "empty", "a header with units and lines of numbers")
    return Table(source, header, rows, numbers, comments)


def _fitted(source: str, number: int, cells: list[Any], width: int, hint: str) -> list[Any]:
    """The cells of a line, as many as the header has."""
    extra = [cell for cell in cells[width:] if not missing(cell)]
    if extra:
        raise RecordingError.of(
            source,
            f"line {number}",
            f"{quoted(extra[0])} stands right of the last of {width} columns",
            f"a cell for each column{hint}",
        )
    return [*cells[:width], *[None] * (width - len(cells))]
