"""Processes that simulate, as a worker sees them."""

import json
import os
import select
import signal
import subprocess
import sys
import tempfile
import time
from contextlib import suppress
from dataclasses import asdict
from pathlib import Path

import grus
from grus.campaign.job import Job

PACKAGES = str(Path(grus.__file__).resolve().parents[1])


def simulate(job: Job, log: Path) -> int | None:
    """Exit code of a process that does the job and writes to `log`; None when its time was over."""
    warm = _free()
    code = warm.simulate(job, log)
    _idle.append(warm)
    return code


def start_ahead() -> None:
    """Starts a process that will have loaded YADE when the first job comes."""
    _idle.append(_Warm())


def _free() -> "_Warm":
    # A list's own operations are safe between the threads of a worker.
    while _idle:
        with suppress(IndexError):  # another thread was quicker
            warm = _idle.pop()
            if warm.alive:
                return warm
    return _Warm()


_idle: list["_Warm"] = []
"""Processes that wait for a job; each does one at a time."""


class _Warm:
    """A process of grus.campaign.warm."""

    def __init__(self) -> None:
        paths = [PACKAGES, *filter(None, [os.environ.get("PYTHONPATH")])]
        # OpenMP reads its variable while YADE is loaded.
        surroundings = os.environ | {"OMP_NUM_THREADS": "1", "PYTHONPATH": os.pathsep.join(paths)}
        self.log = tempfile.TemporaryFile()
        self.process = subprocess.Popen(
            [sys.executable, "-P", "-m", "grus.campaign.warm"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self.log,
            bufsize=0,
            env=surroundings,
            # Ctrl-C is for the campaign, which ends it by closing its standard input. Not a session of its own: it would
            # get as much of the processor as all processes of the campaign's session together, `nice` or not.
            process_group=0,
        )

    @property
    def alive(self) -> bool:
        return self.process.poll() is None

    def simulate(self, job: Job, log: Path) -> int | None:
        line = json.dumps([asdict(job), str(log)]).encode() + b"\n"
        try:
            self.process.stdin.write(line)
        except BrokenPipeError:
            return self._lost(log)
        simulation = self._answer()
        if simulation is None:
            return self._lost(log)
        limit = None if job.time_limit is None else time.monotonic() + job.time_limit
        if not self._told(limit):
            os.kill(
                simulation, signal.SIGKILL
            )  # it cannot be another's: it is waited for by the warm process
            self._answer()
            return None
        code = self._answer()
        if code is None:
            _kill(simulation)
            return self._lost(log)
        return code

    def _told(self, limit: float | None) -> bool:
        """Whether there is an answer, or the end of all answers, before `limit` (of the monotonic clock)."""
        left = None if limit is None else max(0.0, limit - time.monotonic())
        return bool(select.select([self.process.stdout], [], [], left)[0])

    def _answer(self) -> int | None:
        line = self.process.stdout.readline()
        return int(line) if line.endswith(b"\n") else None

    def _lost(self, log: Path) -> int:
        """Exit code of the warm process, which could not load YADE or was killed; `log` gets what it wrote."""
        code = self.process.wait()
        self.log.seek(0)
        with open(log, "ab") as file:
            file.write(self.log.read())
        return code


def _kill(process: int) -> None:
    try:
        os.kill(process, signal.SIGKILL)
    except ProcessLookupError:
        pass  # it has ended by itself
