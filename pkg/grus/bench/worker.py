"""A child process with one block of elements, which is timed whenever it is asked."""

import json
import os
import subprocess
from collections.abc import Mapping, Sequence
from contextlib import suppress

from grus.bench.cases import Case
from grus.errors import GrusError

STRETCH = 0.1  # about the least duration of one measurement [s]
STEPS = 10  # a measurement is a multiple of this, where the loop has no unit of its own


class Worker:
    """A process that says {"elements", "bonds"} of its block, then answers numbers of steps with the seconds they took.

    Both are lines of JSON; other lines are passed over.
    """

    def __init__(
        self,
        case: Case,
        loop: str,
        command: Sequence[str],
        environment: Mapping[str, str] = {},
        unit: int = STEPS,
    ) -> None:
        self.case, self.loop, self.unit = case, loop, unit
        self.said = ""
        self.process = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            env=os.environ | {"OMP_NUM_THREADS": str(case.threads)} | environment,
        )

    def ready(self) -> None:
        """Waits until the block is built, and finds how many steps make a measurement."""
        self.size = self.built()
        self.run(self.unit)
        self.steps = self.unit * max(1, round(STRETCH / max(self.run(self.unit), 1e-6)))

    def built(self) -> dict[str, int]:
        """Numbers of elements and of bonds, once the block is there."""
        return self._answer()

    def run(self, steps: int) -> float:
        """Seconds for so many steps."""
        self.say(str(steps))
        return float(self._answer())

    def close(self) -> None:
        """Ends the process, whatever it is doing."""
        with suppress(BrokenPipeError):
            self.process.stdin.close()
        self.process.terminate()
        self.process.wait()
        self.process.stdout.close()

    def say(self, line: str) -> None:
        """Raises GrusError when the process has ended."""
        try:
            print(line, file=self.process.stdin, flush=True)
        except BrokenPipeError:
            self.line()  # what it said before it ended

    def line(self) -> str:
        """Next line of the process; raises GrusError when it has ended."""
        line = self.process.stdout.readline()
        if not line:
            why = f": {self.said}" if self.said else ""
            raise GrusError(f"the measurement of {self.loop} on {self.case.name} ended early{why}")
        self.said = line.strip() or self.said
        return line

    def _answer(self) -> dict[str, int] | float:
        while True:
            with suppress(json.JSONDecodeError):
                return json.loads(self.line())
