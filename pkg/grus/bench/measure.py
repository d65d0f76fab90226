"""Times the loops by turns, so that a busy machine disturbs all of them alike."""

from collections.abc import Callable
from dataclasses import dataclass
from statistics import median

from grus.bench.cases import LOOPS, Case
from grus.bench.esys_particle import Esys
from grus.bench.lammps import Lammps
from grus.bench.worker import Worker
from grus.bench.yade_loop import Yade

REPEATS = 7
ROUNDS = REPEATS + 1  # of a case: blocks are built in the first
CODES = {"lammps": Lammps, "esys": Esys}


@dataclass(frozen=True)
class Timing:
    """One loop on one case: medians of `REPEATS` measurements.

    step: duration of a step [s]. Bonds and elements are counted in the scene.
    """

    case: Case
    loop: str
    elements: int
    bonds: int
    step: float
    repeats: int

    @property
    def per_bond(self) -> float:
        """Duration of a step over the number of bonds [s]."""
        return self.step / self.bonds

    @property
    def rate(self) -> float:
        """Elements times steps in a second [1/s]; body-steps, where every element is a body."""
        return self.elements / self.step


def loops(case: Case) -> list[str]:
    """Names of the loops that can compute the case on this machine."""
    return [loop for loop in case.loops if loop in LOOPS or CODES[loop].installed()]


def measure(case: Case, progress: Callable[[], None] = lambda: None) -> list[Timing]:
    """Times all loops of a case; `progress()` is called after each of `ROUNDS`.

    Raises GrusError when a measuring process ends early.
    """
    workers: list[Worker] = []
    try:
        for loop in loops(case):
            workers.append(CODES.get(loop, Yade)(case, loop))
        for worker in workers:
            worker.ready()
        progress()
        seconds = {worker.loop: [] for worker in workers}
        for _ in range(REPEATS):
            for worker in workers:
                seconds[worker.loop].append(worker.run(worker.steps) / worker.steps)
            progress()
    finally:
        for worker in workers:
            worker.close()
    return [
        Timing(case, w.loop, **w.size, step=median(seconds[w.loop]), repeats=REPEATS)
        for w in workers
    ]
