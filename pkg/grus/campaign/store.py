"""Outcomes in a folder, which several campaigns may use at the same time."""

import fcntl
import hashlib
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from grus.campaign.checked_file import read_checked, write_checked
from grus.campaign.outcome import Outcome
from grus.errors import GrusError
from grus.files import PARTIAL, write_text

Tell = Callable[[str], None]


def quiet(line: str) -> None:
    """Tells nobody."""


class Store:
    """Folder of outcomes by the keys of their runs.

    runs/KEY.h5: one outcome. specimens: prepared specimens, each with its checksum. work: tests that are not over yet.
    locks: held while a run or a specimen is made, and let go by the system when the process that holds one dies.
    """

    def __init__(self, folder: str | Path) -> None:
        self.folder = Path(folder).absolute()
        self.runs = self.folder / "runs"
        self.specimens = self.folder / "specimens"

    def make(self) -> "Store":
        """Makes the folders; returns the store. Raises OSError when that cannot be done."""
        for folder in (self.runs, self.specimens, self.folder / "work", self.folder / "locks"):
            folder.mkdir(parents=True, exist_ok=True)
        return self

    def path(self, key: str) -> Path:
        return self.runs / f"{key}.h5"

    def work(self, key: str) -> Path:
        """Folder of a test that is not over yet."""
        return self.folder / "work" / key

    def forget_work(self, key: str) -> None:
        """Removes that folder."""
        shutil.rmtree(self.work(key), ignore_errors=True)

    def find(self, key: str, tell: Tell = quiet) -> Outcome | None:
        """The outcome of a run, None when there is none. A damaged file counts as none; `tell` is called with a line."""
        try:
            found = Outcome.from_bytes(read_checked(self.path(key)))
        except FileNotFoundError:
            return None
        except GrusError as error:
            tell(f"{error}; it is computed anew")
            return None
        return found if found.key == key else None

    def save(self, outcome: Outcome) -> None:
        """Stores an outcome, complete or not at all; one of the same run is replaced. Raises OSError."""
        write_checked(self.path(outcome.key), outcome.to_bytes())

    def outcomes(self, tell: Tell = quiet) -> Iterator[Outcome]:
        """All that can be read, in the order of their keys."""
        for path in sorted(self.runs.glob("[0-9a-f]*.h5")):
            found = self.find(path.stem, tell)
            if found is not None:
                yield found

    def specimen(self, key: str) -> Path:
        """Where `grus.preparation.prepare` keeps the specimen of this key."""
        return self.specimens / f"specimen-{key[:16]}.h5"

    def seal_specimen(self, key: str) -> None:
        """Stores the checksum of a specimen."""
        write_text(_seal(self.specimen(key)), _checksum(self.specimen(key)))

    def check_specimen(self, key: str, tell: Tell = quiet) -> bool:
        """Whether the specimen is there; a damaged one is removed, and `tell` is called with a line."""
        path = self.specimen(key)
        if not path.exists():
            return False
        seal = _seal(path)
        if seal.exists() and seal.read_text(encoding="utf-8") == _checksum(path):
            return True
        tell(f"{path}: damaged or incomplete; it is prepared anew")
        path.unlink(missing_ok=True)
        return False

    @contextmanager
    def lock(self, name: str) -> Iterator[None]:
        """Held by one process at a time; the others wait here."""
        with open(self.folder / "locks" / name, "w", encoding="utf-8") as file:
            fcntl.flock(file, fcntl.LOCK_EX)
            # Whoever holds the lock is the only one who writes under this name: what lies there is of a killed process.
            for partial in self.runs.glob(f"{PARTIAL}*.{name}.h5"):
                partial.unlink(missing_ok=True)
            yield


def _seal(path: Path) -> Path:
    return path.with_suffix(".sha256")


def _checksum(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()
