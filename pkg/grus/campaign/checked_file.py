"""Files that tell whether they are still what was written.

The SHA-256 of the content stands behind it. An HDF5 file stays one: readers do not look behind its end.
"""

import hashlib
from pathlib import Path

from grus.errors import GrusError
from grus.files import replacing

MARK = b"\nsha256 "
TAIL = len(MARK) + 64


def write_checked(path: Path, content: bytes) -> None:
    """Writes the file with its checksum, complete or not at all."""
    with replacing(path) as partial:
        partial.write_bytes(content + MARK + hashlib.sha256(content).hexdigest().encode())


def read_checked(path: Path) -> bytes:
    """The content. Raises FileNotFoundError, or GrusError when it is not what was written."""
    data = path.read_bytes()
    content, tail = data[:-TAIL], data[-TAIL:]
    if tail != MARK + hashlib.sha256(content).hexdigest().encode():
        raise GrusError(f"{path}: damaged; its checksum differs")
    return content
