"""What was done to the specimen: rests and the moves between them, named."""

from dataclasses import dataclass

import numpy as np

from grus.record import Kind
from grus.recording.path import CLEAR, STEP, StressPath
from grus.recording.rests import rests

SEATING = 0.05
"""Largest stress of a seating, as a share of the highest stress of the test."""
REACHED = 1.06
"""Stress over the highest before, up to which a test is reloaded only."""

Found = tuple[int, int, float, float]
"""First and last row of a rest or move, stress from and to [Pa]; both are the same in a rest."""


@dataclass(frozen=True)
class Part:
    """Rows `first` to `last`, stress from `start` to `end` [Pa], and the number of the stage."""

    kind: Kind
    stage: int
    first: int
    last: int
    start: float
    end: float


def find_parts(stress: np.ndarray, x: np.ndarray, path: StressPath) -> list[Part]:
    """Parts of a test by its stress (n,) [Pa] at places x (n,), not falling; neighbours share a row."""
    return named(find(stress, x, path), path)


def find(stress: np.ndarray, x: np.ndarray, path: StressPath) -> list[Found]:
    """Rests (first, last, level, level) and moves (first, last, from, to), in order."""
    result: list[Found] = []
    here, level, resting = 0, None, False
    end = len(stress) - 1
    for first, last in [*rests(stress, x, path), (end, end)]:
        target = float(np.median(stress[first : last + 1])) if last > first else None
        moves = path.moves(here, first, level, target)
        result += [(move.first, move.last, move.start, move.end) for move in moves]
        if moves and last == first:
            break
        if not moves and (resting or not result or last > first):
            # Nothing has moved since the rest before, or since the first reading.
            start = result.pop()[0] if resting else here
        elif not moves:
            start = None
            result[-1] = (result[-1][0], last, *result[-1][2:])
        else:
            start = first
        if start is not None:
            level = float(np.median(stress[start : last + 1]))
            result.append((start, last, level, level))
        resting, here = start is not None, last
    return result


def named(found: list[Found], path: StressPath, stages: list[int] | None = None) -> list[Part]:
    """The same with kinds and stages, counted where they are not given: 0 is the seating.

    Reloading beyond the highest stress is two parts of one stage.
    """
    parts: list[Part] = []
    highest, top = -np.inf, path.stress.max()
    stage = 0
    for number, (first, last, start, end) in enumerate(found):
        rests_here = start == end
        if stages is None:
            seats = rests_here and number == 0 and start <= SEATING * top
            stage += 0 if seats else 1
        else:
            stage = stages[number]
            seats = stage == 0
        below = highest - start >= max(STEP * abs(highest), CLEAR * path.noise[first])
        if rests_here:
            kinds = [("seat" if seats else "hold", first, last, start, end)]
        elif end < start:
            kinds = [("unload", first, last, start, end)]
        elif not below or not np.isfinite(highest):
            kinds = [("load", first, last, start, end)]
        elif end <= REACHED * highest:
            kinds = [("reload", first, last, start, end)]
        else:
            beyond = path.at(np.arange(first, last)) > highest * (1 + 1e-6)
            middle = int(np.argmax(beyond)) - 1 + first if beyond.any() else last - 1
            kinds = [("reload", first, middle, start, highest)] * (middle > first)
            kinds.append(
                ("load", max(middle, first), last, highest if middle > first else start, end)
            )
        parts += [Part(kind, stage, *rest) for kind, *rest in kinds]
        highest = max(highest, start, end)
    return parts
