"""Recordings in text: comma, semicolon or tab between the cells."""

import csv
import io
import re

from grus.recording.errors import RecordingError
from grus.recording.table import Table, table_of

_BINARY = re.compile(r"[\x00-\x08\x0e-\x1f]")
_IN_BRACKETS = re.compile(r"\[[^\]]*\]|\([^)]*\)|\"[^\"]*\"")
_ALLOWED = "text (CSV) or a spreadsheet (xlsx)"


def read_text(content: bytes, source: str) -> Table:
    """Table in the bytes of a text file; RecordingError for what is none."""
    text, notes = _decoded(content, source)
    if _BINARY.search(text):
        raise RecordingError.of(source, "", "neither text nor a spreadsheet", _ALLOWED)
    delimiter = _delimiter(text)
    hint = " (with decimal commas: semicolons or tabs between cells)" if delimiter == "," else ""
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=delimiter, skipinitialspace=True)
    try:
        lines = [(reader.line_num, cells) for cells in reader]
    except csv.Error as error:
        raise RecordingError.of(source, f"line {reader.line_num}", str(error), _ALLOWED) from None
    table = table_of(source, lines, hint)
    return Table(source, table.header, table.rows, table.lines, table.comments, notes)


def _decoded(content: bytes, source: str) -> tuple[str, tuple[str, ...]]:
    if content.startswith((b"\xff\xfe", b"\xfe\xff")):
        try:
            return content.decode("utf-16"), ()
        except UnicodeDecodeError:
            raise RecordingError.of(source, "", "broken UTF-16", _ALLOWED) from None
    try:
        return content.decode("utf-8-sig"), ()
    except UnicodeDecodeError:
        return content.decode("latin-1"), ("read as Latin-1, since it is not UTF-8",)


def _delimiter(text: str) -> str:
    """What stands most often between the names of the header."""
    lines = (line.strip() for line in text.splitlines())
    header = next((line for line in lines if line and not line.startswith("#")), "")
    names = _IN_BRACKETS.sub("", header)
    return max(";\t,", key=names.count)
