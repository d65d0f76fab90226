"""Running one stage of an oedometer test to its end."""

import math
import time
from collections.abc import Callable
from typing import NoReturn

from yade import O

from grus.card import Card
from grus.errors import GrusError
from grus.oedometer.files import TestFiles
from grus.oedometer.clock import ageing
from grus.oedometer.program import Planned
from grus.oedometer.slices import Slices
from grus.oedometer.test import at_end, ledger, servo

Progress = Callable[[float, str], None]
"""Called with the share of the test that is done (0 while the specimen is prepared) and a line on what is going on."""
SAVING = 0.05
"""Largest share of the time that goes into checkpoints within a stage."""


class StageRun:
    """The stage of number `servo().stage` among `stages`.

    The scene is saved every `checkpoint` seconds, and less often when that takes long.
    """

    def __init__(
        self, card: Card, stages: list[Planned], files: TestFiles, checkpoint: float
    ) -> None:
        self.card, self.stages, self.files, self.checkpoint = card, stages, files, checkpoint
        self.number = servo().stage
        self.stage = stages[self.number]
        self.first = O.iter

    @property
    def name(self) -> str:
        """As in "stage 2, load to 200 kPa"."""
        return f"stage {self.number}, {self.stage.name}"

    def finish(self, tell: Progress) -> None:
        """Raises GrusError when the specimen comes to a bad end, or when the stage takes too many steps."""
        slices = Slices()
        while not at_end():
            try:
                slices.run()
            except RuntimeError as complaint:
                self._fail(str(complaint))
            tell(*self._progress())
            self._give_up_in_time()
            if time.monotonic() - self.files.saved > max(self.checkpoint, self.files.took / SAVING):
                self.files.save_scene()

    def _progress(self) -> tuple[float, str]:
        s, clock = servo(), ageing()
        where = f"{s.topStress / 1e3:.4g} kPa"
        if clock is not None and clock.holding:
            passed = max(clock.clock - self.stage.begins, 0.0)
            done = math.log1p(passed) / math.log1p(self.stage.ends - self.stage.begins)
            where = f"{passed / 3600:.4g} h"
        else:
            before = self.stages[self.number - 1].stress if self.number else 0.0
            done = _share(before, (s.topStress + s.bottomStress) / 2, self.stage.stress)
        return (
            (self.number + done) / len(self.stages),
            f"{self.stage.name}: {where}, strain {s.strain:.3%}, {ledger().breaks} bonds broken, step {O.iter}",
        )

    def _fail(self, complaint: str) -> NoReturn:
        """Leaves the last checkpoint, which is from before, as it is."""
        last = "nothing was saved before"
        if self.files.scene.exists():
            last = f"the last good state is {self.files.scene}"
        raise GrusError(f"{self.card.source}: {self.name}, step {O.iter}: {complaint}; {last}")

    def _give_up_in_time(self) -> None:
        most = self.card.oedometer.max_steps
        if O.iter - self.first <= most or at_end():
            return
        self.files.save_scene()
        s = servo()
        raise GrusError(
            f"{self.card.source}: oedometer.max_steps = {most}: {self.name} has not ended (stress "
            f"{s.topStress / 1e3:.4g} kPa, unbalanced force {s.unbalanced:.2g}); allowed: more. "
            f"The state is saved in {self.files.folder}"
        )


def _share(before: float, now: float, target: float) -> float:
    """How much of the way to the target is done, 0 to 1: in the logarithm of stress, as strain goes."""
    if before <= 0 or now <= 0:
        return 0.0
    return (
        min(max(math.log(now / before) / math.log(target / before), 0), 1)
        if target != before
        else 0.5
    )
