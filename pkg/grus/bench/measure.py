"""Times the loops by turns, so that a busy machine disturbs all of them alike."""

import json
import os
import subprocess
import sys
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from statistics import median

from grus.bench.cases import LOOPS, SUBSTEPS, Case
from grus.errors import GrusError

REPEATS = 7
STRETCH = 0.1  # about the least duration of one measurement [s]
STEPS = 10  # a measurement is a multiple of this, or of GrainLoop's sub-steps in a YADE step


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


class _Worker:
    """A child process with one scene."""

    def __init__(self, case: Case, loop: str) -> None:
        self.case, self.loop = case, loop
        tuned = {"GLIBC_TUNABLES": "glibc.malloc.hugetlb=1"} if loop.endswith("_tuned") else {}
        self.process = subprocess.Popen(
            [sys.executable, "-P", "-m", "grus.bench.worker", json.dumps(asdict(case)), loop],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
            env=os.environ | {"OMP_NUM_THREADS": str(case.threads)} | tuned,
        )

    def ready(self) -> None:
        """Waits until the scene is built, and finds how many steps make a measurement."""
        self.size = json.loads(self._line())
        unit = SUBSTEPS if self.loop == "grainloop" else STEPS
        self.run(unit)
        self.steps = unit * max(1, round(STRETCH / max(self.run(unit), 1e-6)))

    def run(self, steps: int) -> float:
        """Seconds for so many steps."""
        print(steps, file=self.process.stdin, flush=True)
        return float(self._line())

    def _line(self) -> str:
        line = self.process.stdout.readline()
        if not line:
            raise GrusError(f"the measurement of {self.loop} on {self.case.name} ended early")
        return line

    def close(self) -> None:
        self.process.stdin.close()
        self.process.wait()


def measure(
    cases: Sequence[Case], progress: Callable[[int, int], None] | None = None
) -> list[Timing]:
    """Times all loops on each case; `progress(done, of)` is called after each case.

    Raises GrusError when a measuring process ends early.
    """
    timings = []
    for done, case in enumerate(cases):
        workers = []
        try:
            workers += [_Worker(case, loop) for loop in LOOPS]
            for worker in workers:
                worker.ready()
            seconds = {worker.loop: [] for worker in workers}
            for _ in range(REPEATS):
                for worker in workers:
                    seconds[worker.loop].append(worker.run(worker.steps) / worker.steps)
        finally:
            for worker in workers:
                worker.close()
        timings += [
            Timing(case, w.loop, **w.size, step=median(seconds[w.loop]), repeats=REPEATS)
            for w in workers
        ]
        if progress:
            progress(done + 1, len(cases))
    return timings
