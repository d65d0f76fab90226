"""Recordings in spreadsheets (xlsx)."""

import io

import openpyxl

from grus.recording.channels import BY_KEY, key
from grus.recording.errors import RecordingError, quoted
from grus.recording.header import split
from grus.recording.table import Table, table_of

MAGIC = b"PK\x03\x04"
"""How an xlsx file begins."""


def read_spreadsheet(content: bytes, source: str, sheet: str | None = None) -> Table:
    """Table in the bytes of an xlsx file; RecordingError for what is none.

    sheet: name of the sheet; without it the first one that has a channel in its header.
    """
    try:
        book = openpyxl.load_workbook(io.BytesIO(content), read_only=True, data_only=True)
        names = list(book.sheetnames)
        sheets = {name: _lines(book[name]) for name in names if hasattr(book[name], "iter_rows")}
    except Exception as error:  # of many kinds: from the archive, the XML, or openpyxl
        reason = f"not a readable spreadsheet ({type(error).__name__})"
        raise RecordingError.of(source, "", reason, "text (CSV) or a spreadsheet (xlsx)") from error
    if sheet is not None and sheet not in sheets:
        allowed = ", ".join(quoted(name) for name in sheets)
        raise RecordingError.of(source, "", f"no sheet {quoted(sheet)}", allowed)
    chosen = sheet if sheet is not None else next(filter(lambda n: _fits(sheets[n]), sheets), None)
    if chosen is None:
        chosen = next(iter(sheets), None)
    if chosen is None:
        raise RecordingError.of(source, "", "no sheet with cells", "a spreadsheet with a table")
    return table_of(source, sheets[chosen])


def _lines(sheet) -> list[tuple[int, list]]:
    return [(number, list(row)) for number, row in enumerate(sheet.iter_rows(values_only=True), 1)]


def _fits(lines: list[tuple[int, list]]) -> bool:
    """Whether the first line that is no comment names a channel."""
    for _, cells in lines:
        texts = [cell for cell in cells if isinstance(cell, str)]
        if texts and not texts[0].lstrip().startswith("#"):
            return any(key(split(text)[0]) in BY_KEY for text in texts)
    return False
