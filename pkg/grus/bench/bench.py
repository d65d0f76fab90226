"""The measurement of many cases."""

from collections.abc import Callable, Sequence
from pathlib import Path

from grus.bench.cases import Case
from grus.bench.measure import ROUNDS, Timing, loops, measure
from grus.bench.store import read, write


def bench(
    cases: Sequence[Case],
    folder: str | Path,
    progress: Callable[[int, int], None] | None = None,
    restart: bool = False,
) -> list[Timing]:
    """Measures the cases that `folder` has not yet, and returns all timings of the folder, sorted by case.

    Each case is stored when it is measured. progress(done, of): called as rounds of measuring pass. restart: forget
    what the folder has.
    Raises GrusError when a measuring process ends early, or bench.json in `folder` is damaged or was measured under
    other conditions.
    """
    timings = [] if restart else read(folder)
    write(folder, timings)
    measured = {(t.case, t.loop) for t in timings}
    missing = [case for case in cases if any((case, loop) not in measured for loop in loops(case))]
    done = 0

    def show() -> None:
        nonlocal done
        done += 1
        if progress:
            progress(done, ROUNDS * len(missing))

    if progress and missing:
        progress(0, ROUNDS * len(missing))
    for case in missing:
        try:
            found = measure(case, show)
        except KeyboardInterrupt:
            raise KeyboardInterrupt(
                f"interrupted; {folder} has what was measured, and the same command goes on"
            ) from None
        timings = _sorted([t for t in timings if t.case != case] + found)
        write(folder, timings)
    return timings


def _sorted(timings: Sequence[Timing]) -> list[Timing]:
    """By case; loops of a case stay in their order."""
    return sorted(
        timings, key=lambda t: (t.case.dimension, t.case.stamped, t.case.elements, t.case.threads)
    )
