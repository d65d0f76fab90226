"""Writing a record as a recording, to be read again or by other programs."""

import io
from os import PathLike
from pathlib import Path

from grus.errors import one_line
from grus.files import write_text
from grus.record import Record


def write(record: Record, path: str | PathLike) -> Path:
    """CSV with a header that carries the units, all in SI; what `meta` and `notes` say stands above in comments.

    The file appears complete or not at all.
    """
    text = io.StringIO()
    for name, value in record.meta.items():
        unit = " m" if name == "height" else ""
        text.write(f"# {one_line(name)} = {one_line(value)}{unit}\n")
    for note in record.notes:
        text.write(f"# {one_line(note)}\n")
    record.frame().to_csv(text, index=False, lineterminator="\n")
    return write_text(path, text.getvalue())
