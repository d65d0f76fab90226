"""Files that appear complete or not at all."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


PARTIAL = ".partial-"


@contextmanager
def replacing(path: str | Path) -> Iterator[Path]:
    """Gives a temporary path beside `path` to write to; on success it takes the name, on an error it is removed."""
    path = Path(path)
    # The suffix stays last, because some writers choose the format by it.
    partial = path.with_name(f"{PARTIAL}{os.getpid()}.{path.name}")
    try:
        yield partial
        os.replace(partial, path)
    finally:
        partial.unlink(missing_ok=True)


def write_text(path: str | Path, text: str) -> Path:
    """Writes a text file, complete or not at all."""
    with replacing(path) as partial:
        partial.write_text(text, encoding="utf-8")
    return Path(path)


def discard_partial(folder: str | Path) -> None:
    """Removes what a process that was killed while it wrote has left in `folder`."""
    for partial in Path(folder).glob(f"{PARTIAL}*"):
        pid = partial.name.removeprefix(PARTIAL).split(".")[0]
        if not Path("/proc", pid).exists():
            partial.unlink(missing_ok=True)
