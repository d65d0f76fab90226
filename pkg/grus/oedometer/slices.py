"""Running the current scene a little at a time."""

import time
from collections.abc import Iterator
from contextlib import contextmanager

from yade import O, log

from grus.scene.grain_engines import SUBSTEPS

LOOK = 0.5
"""Seconds between two looks at what happens; nothing, Ctrl-C neither, is heard meanwhile."""
MOST = 100
"""Rounds of GrainLoop in a slice."""


class Slices:
    """Slices of a run, which take about `LOOK` seconds each.

    They end where GrainLoop hands back anyway: doing so elsewhere changes the last digits, and so a run would depend on the
    clock.
    """

    def __init__(self) -> None:
        self.rounds = 1

    def run(self) -> None:
        """One slice, or less when an engine stops the run. Raises RuntimeError with what an engine complains of."""
        start = time.monotonic()
        with _silent():
            O.run(self.rounds * SUBSTEPS - O.iter % SUBSTEPS, True)
        fitting = self.rounds * LOOK / max(time.monotonic() - start, 1e-3)
        self.rounds = min(max(round(fitting), 1), MOST)


@contextmanager
def _silent() -> Iterator[None]:
    """YADE does not print what it raises anyway."""
    names = ("ThreadRunner", "yadeWrapper.cpp")
    for name in names:
        log.setLevel(name, log.NOFILTER)
    try:
        yield
    finally:
        for name in names:
            log.unsetLevel(name)
