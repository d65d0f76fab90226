"""Progress of long work on the terminal."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn


@contextmanager
def progress_bar(what: str) -> Iterator[Callable[[int, int], None]]:
    """Gives `show(done, of)`; the bar appears at its first call, so that refused input is told without one."""
    columns = (TextColumn(what), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    bar = Progress(*columns, console=Console(stderr=True))
    task = bar.add_task(what, total=None)

    started = False

    def show(done: int, of: int) -> None:
        nonlocal started
        if not started:
            bar.start()
        started = True
        bar.update(task, completed=done, total=of)

    try:
        yield show
    finally:
        if started:
            bar.stop()
