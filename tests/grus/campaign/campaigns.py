"""Campaigns in processes of their own, and what they must give."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import psutil

from grus.campaign import Outcome, Run, Store
from grus.card import Card

HERE = Path(__file__).parent
PLANE = HERE.parents[1] / "cards" / "plane.toml"
SEEDS = 8
WARM = "grus.campaign.warm"


def disturbed_runs() -> list[Run]:
    """Crushing tests slow enough to be disturbed on their way."""
    card = Card.from_file(PLANE).with_overrides({"crush.speed": "0.0002 m/s"})
    return [Run("crush", card.with_overrides({"seed": seed})) for seed in range(SEEDS)]


def assert_same(found: dict[str, Outcome], expected: dict[str, Outcome]) -> None:
    """Bit by bit."""
    assert set(found) == set(expected)
    for key, outcome in found.items():
        other = expected[key]
        assert outcome.failed is None
        assert outcome.figures == other.figures
        assert outcome.card == other.card
        assert outcome.record.units == other.record.units
        for name in other.record.channels:
            np.testing.assert_array_equal(outcome.record[name], other.record[name])


class Client:
    """A campaign in a process of its own."""

    def __init__(self, store: Path, jobs: int = 1, scheduler: str = "-"):
        command = [sys.executable, HERE / "client.py", store, jobs, scheduler]
        self.store = Store(store)
        self.process = subprocess.Popen(
            list(map(str, command)),
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            process_group=0,
        )

    def children(self, word: str) -> list[psutil.Process]:
        """Processes below the client with a word in their command line."""
        return below(self.process.pid, word)

    def simulations(self) -> list[psutil.Process]:
        """Processes that simulate, each forked from one that has loaded YADE."""
        warm = {one.pid for one in self.children(WARM)}
        return [one for one in self.children(WARM) if _parent(one) in warm]

    def end(self) -> tuple[str, str]:
        """Standard output and error, when it is over."""
        return self.process.communicate(timeout=300)

    def interrupt(self) -> None:
        """As Ctrl-C in a terminal does."""
        os.killpg(self.process.pid, signal.SIGINT)


def _parent(process: psutil.Process) -> int | None:
    try:
        return process.ppid()
    except psutil.Error:
        return None  # it has ended meanwhile


def below(pid: int, word: str) -> list[psutil.Process]:
    found = []
    for child in psutil.Process(pid).children(recursive=True):
        try:
            if any(word in part for part in child.cmdline()):
                found.append(child)
        except psutil.Error:
            pass  # it has ended meanwhile
    return found


def until(condition: Callable, seconds: float = 300):
    """The first true value of `condition`."""
    for _ in range(int(seconds / 0.02)):
        value = condition()
        if value:
            return value
        time.sleep(0.02)
    raise AssertionError("it did not come to that")
