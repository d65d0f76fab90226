"""Checkpoint and stages of one oedometer test in a folder."""

import shutil
import time
from pathlib import Path

import h5py
from yade import O

from grus.card import Card
from grus.errors import GrusError, one_line
from grus.files import discard_partial, replacing
from grus.oedometer.result import StageEnd
from grus.ownership import OWNER, claim
from grus.scene import Contacts, Snapshot

GROUPS = {"state": Snapshot, "contacts": Contacts}
NUMBERS = [name for name in StageEnd.__annotations__ if name not in GROUPS]


class TestFiles:
    """`folder`/stages holds the last scene and the end of every stage. Raises GrusError when it is another card's.

    saved: when the scene was saved last (`time.monotonic()`). took: how long that took [s].
    """

    __test__ = False  # not one for pytest

    def __init__(self, card: Card, folder: Path) -> None:
        claim(folder, card)
        self.home, self.folder = folder, folder / "stages"
        self.folder.mkdir(exist_ok=True)
        self.scene = self.folder / "scene.yade"  # compressed it takes three times as long
        self.saved, self.took = time.monotonic(), 0.0
        discard_partial(self.folder)

    def discard(self) -> None:
        """Forgets the test; the prepared specimen stays."""
        shutil.rmtree(self.folder)
        self.folder.mkdir()

    def release(self) -> None:
        """Leaves the folder to any card, unless there is something of this test in it."""
        if any(self.folder.iterdir()):
            return
        self.folder.rmdir()
        (self.home / OWNER).unlink()
        if not any(self.home.iterdir()):
            self.home.rmdir()

    def save_scene(self) -> None:
        start = time.monotonic()
        with replacing(self.scene) as partial:
            O.save(str(partial), quiet=True)
        self.saved = time.monotonic()
        self.took = self.saved - start

    def load_scene(self) -> bool:
        """Makes the saved scene the current one; False when there is none. Raises GrusError for one of another build."""
        if not self.scene.exists():
            return False
        O.reset()
        try:
            O.load(str(self.scene), quiet=True)
        except (RuntimeError, ValueError) as error:
            O.reset()
            raise _unreadable(self.scene, error) from None
        return True

    def path(self, number: int) -> Path:
        return self.folder / f"stage-{number:03d}.h5"

    def has_stage(self, number: int) -> bool:
        return self.path(number).exists()

    def save_stage(self, end: StageEnd) -> None:
        with replacing(self.path(end.number)) as partial, h5py.File(partial, "w") as file:
            for name in NUMBERS:
                file.attrs[name] = getattr(end, name)
            for group in GROUPS:
                for name, values in vars(getattr(end, group)).items():
                    file.create_dataset(f"{group}/{name}", data=values)

    def load_stage(self, number: int) -> StageEnd:
        """What `save_stage` wrote, bit by bit. Raises GrusError for a file that is not one of these."""
        try:
            with h5py.File(self.path(number), "r") as file:
                parts = {
                    group: kind(**{name: file[group][name][()] for name in file[group]})
                    for group, kind in GROUPS.items()
                }
                numbers = {name: file.attrs[name] for name in NUMBERS}
        except (OSError, KeyError, TypeError) as error:
            raise _unreadable(self.path(number), error) from None
        plain = {n: v.item() if hasattr(v, "item") else v for n, v in numbers.items()}
        return StageEnd(**plain, **parts)


def _unreadable(path: Path, error: Exception) -> GrusError:
    return GrusError(
        f"{path}: cannot be read ({one_line(error)}); allowed: what this build of Grus saved, or a restart of the test"
    )
