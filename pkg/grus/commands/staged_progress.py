"""Progress of a test in stages, on standard error: a bar on a terminal, else a line now and then."""

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from datetime import timedelta

from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn

Show = Callable[[float, str], None]
SILENCE = 60.0
"""Seconds after which a line is written though little has happened."""
STRIDE = 0.05
"""Share of the test after which a line is written."""


@contextmanager
def staged_progress() -> Iterator[Show]:
    """Gives `show(share, line)`: what share of the test is done and what is going on.

    The bar appears at its first call, so that refused input is told without one.
    """
    console = Console(stderr=True)
    if not console.is_terminal:
        yield _Lines().show
        return
    bar = _Bar(console)
    try:
        yield bar.show
    finally:
        bar.progress.stop()


class _Clock:
    """How long it may still take, as it has gone since the test itself began, which may be in the middle of it."""

    def __init__(self) -> None:
        self.start: tuple[float, float] | None = None

    def left(self, share: float) -> str:
        """As in "0:03:20 left"; nothing as long as it cannot be told."""
        now = time.monotonic()
        if self.start is None and share > 0:
            self.start = now, share
        if self.start is None or share <= self.start[1]:
            return ""
        begin, first = self.start
        seconds = (now - begin) * (1 - share) / (share - first)
        return f"{timedelta(seconds=round(seconds))} left"


class _Bar:
    def __init__(self, console: Console) -> None:
        columns = (
            TextColumn("{task.percentage:3.0f} %"),
            BarColumn(24),
            TextColumn("{task.fields[left]}"),
            TextColumn("{task.description}"),
        )
        self.progress, self.clock = Progress(*columns, console=console), _Clock()
        self.task = self.progress.add_task("", total=1.0, left="")

    def show(self, share: float, line: str) -> None:
        self.progress.start()
        self.progress.update(
            self.task, completed=share, description=line, left=self.clock.left(share)
        )


class _Lines:
    def __init__(self) -> None:
        self.clock = _Clock()
        self.told, self.share, self.what = 0.0, 0.0, ""

    def show(self, share: float, line: str) -> None:
        """Writes what is new: another thing going on, a stride ahead, or word after a long silence."""
        left, now = self.clock.left(share), time.monotonic()
        what = line.partition(":")[0]
        if what == self.what and share < self.share + STRIDE and now < self.told + SILENCE:
            return
        self.told, self.share, self.what = now, share, what
        print(", ".join(filter(None, (f"{share:4.0%}", left, line))), file=sys.stderr, flush=True)
