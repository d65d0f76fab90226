"""A public recording: where it comes from, and what it is."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from grus.record import Record

RAW = "https://raw.githubusercontent.com"


@dataclass(frozen=True)
class Origin:
    """A repository at one commit: folder of the files, licence, whom to cite, and what the origin does not say."""

    repository: str
    commit: str
    folder: str
    licence: str
    citation: str
    caution: str

    @property
    def page(self) -> str:
        """Where people look at it."""
        return f"https://github.com/{self.repository}/tree/{self.commit}/{self.folder}"

    def url(self, file: str) -> str:
        """Where a file is fetched from."""
        return f"{RAW}/{self.repository}/{self.commit}/{self.folder}/{file}"


@dataclass(frozen=True)
class Dataset:
    """A recording of an origin: its file with SHA-256, what the test was, and what makes a record of the file.

    local: folder of the file in the store, and in a folder of the user that holds several origins.
    """

    name: str
    origin: Origin
    local: str
    file: str
    sha256: str
    test: str
    convert: Callable[[Path], Record]

    @property
    def key(self) -> str:
        """Path of the file in the store."""
        return f"{self.local}/{self.file}"
