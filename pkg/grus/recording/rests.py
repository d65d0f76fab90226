"""Where the stress rests: stretches that a constant explains better than going on from one move to the next."""

from bisect import bisect_left

import numpy as np

from grus.recording.path import CLEAR, STEP, StressPath, group_size
from grus.recording.pieces import fit_line

STEADY = 0.005
"""How far the stress of a rest wanders (drift, overshoot of a servo), as a share of it; one standard deviation."""
WIDE = 0.07
"""Largest distance of a rest from its level, as a share of it."""
CERTAIN, PAIR_CERTAIN = 1.2, 4.0
"""Chi-square that a rest must save over the logarithm of the number of readings; that of two readings only."""
BESIDE = 3.0
"""Distance from the level of a rest, in standard deviations of a reading, within which a reading beside belongs to it."""
PACES = np.array([0.5, 1.0])
"""Paces, over those of the moves before and after, at which the stress may go on where there is no rest."""
TURNS = np.linspace(0.0, 1.0, 5)
"""Places, as shares of the stretch, at which it may go over from the one pace to the other."""
SLOW = 0.4
"""Slope over that of the move before, beyond which the beginning of a stretch belongs to the move."""
SHORTEST = 1e-12
"""Shortest time of a step, as a share of that of the test."""
BRIEF = 0.02
"""Time of a rest of two readings over that of the longest, below which a load that goes on the same way after it only halted: a
specimen that gives way holds up its load."""
MOST_POINTS = 48
"""Readings of a stretch that are looked at, evenly chosen."""


def rests(stress: np.ndarray, x: np.ndarray, path: StressPath) -> list[tuple[int, int]]:
    """First and last row of each rest, in order and apart; stress (n,) [Pa] at places x (n,)."""
    found = []
    near = np.arange(-1, 2)
    starts, ends = (
        np.unique(np.clip(path.pieces[:, [side]] + near, 0, len(stress) - 1)) for side in (0, 1)
    )
    for first in starts.tolist():
        for last in ends[np.searchsorted(ends, first + 1) :].tolist():
            stretch = _Stretch(stress, x, path, first, last)
            if stretch.left:
                break
            certain = CERTAIN if last > first + 1 else PAIR_CERTAIN
            gain = stretch.gain() - certain * np.log(len(stress))
            if gain > 0:
                found.append((last, first, gain))
    return _lasting(stress, x, _completed(stress, path, _best_apart(found)))


def _lasting(
    stress: np.ndarray, x: np.ndarray, chosen: list[tuple[int, int]]
) -> list[tuple[int, int]]:
    """The rests that are no halts of a load."""
    longest = max((x[last] - x[first] for first, last in chosen), default=0.0)

    def halts(first: int, last: int) -> bool:
        if last > first + 1 or first == 0 or last + 1 == len(stress):
            return False
        way = (stress[first] - stress[first - 1]) * (stress[last + 1] - stress[last])
        return bool(way > 0 and x[last] - x[first] < BRIEF * longest)

    return [one for one in chosen if not halts(*one)]


def _completed(
    stress: np.ndarray, path: StressPath, chosen: list[tuple[int, int]]
) -> list[tuple[int, int]]:
    """Rests with the readings beside them that belong to them, where the path was found from groups of readings."""
    most = group_size(len(stress)) - 1
    near = 10 * most + 1
    result: list[tuple[int, int]] = []
    for number, (first, last) in enumerate(chosen):
        before = result[-1][1] + 1 if result else 0
        after = chosen[number + 1][0] if number + 1 < len(chosen) else len(stress)
        start = _reach(
            stress, path, first, max(before, first - most), (first, min(first + near, last + 1))
        )
        end = _reach(
            stress, path, last, min(after - 1, last + most), (max(last + 1 - near, first), last + 1)
        )
        result.append((start, end))
    return result


def _reach(
    stress: np.ndarray, path: StressPath, row: int, farthest: int, near: tuple[int, int]
) -> int:
    """The farthest row from `row` on up to which all readings are at the level of the rows from `near`."""
    sense = 1 if farthest > row else -1
    rows = np.arange(row, farthest + sense, sense)
    off = np.abs(stress[rows] - np.median(stress[slice(*near)])) > BESIDE * path.noise[rows]
    off[0] = False
    return int(rows[np.argmax(off) - 1]) if off.any() else int(rows[-1])


class _Stretch:
    """The readings from one row to another, a candidate for a rest."""

    def __init__(
        self, stress: np.ndarray, x: np.ndarray, path: StressPath, first: int, last: int
    ) -> None:
        self._all, self._x, self._path = stress, x, path
        self.first, self.last = first, last
        self._rows = np.unique(
            np.linspace(first, last, min(last - first + 1, MOST_POINTS)).astype(int)
        )
        self.stress, self.x = stress[self._rows], x[self._rows]
        noise = path.noise[self._rows]
        self.noise = noise
        self.level = float(np.median(self.stress))
        self.scatter = np.hypot(noise.mean(), STEADY * self.level)
        self._room = WIDE * abs(self.level) + 4 * noise[[0, -1]]

    @property
    def left(self) -> bool:
        """Whether the stress has gone so far that no longer stretch can be a rest."""
        return bool(abs(self.stress[-1] - self.level) > 2 * self._room[1])

    def gain(self) -> float:
        """Chi-square that a constant saves, -inf for what is no rest at all."""
        reach = self.x[-1] - self.x[0]
        if reach <= 0 or not self._stays():
            return -np.inf
        line = fit_line(self.x, self.stress, self.noise)
        if abs(line.end - line.start) > WIDE * abs(self.level) + 3 * line.end_error:
            return -np.inf
        before = self._pace(self.first, -1, line.start, reach)
        after = self._pace(self.last, 1, line.end, reach)
        if before is None and after is None:
            return np.inf if len(self._all) == self.last - self.first + 1 else -np.inf
        if before is not None and self._moving(1, before):
            return -np.inf
        if after is not None and self._moving(-1, -after):
            return -np.inf
        saved = self._through(before, after, reach) - np.sum(
            (self.stress - self.stress.mean()) ** 2
        )
        share = (self.last - self.first + 1) / len(self.stress)
        return float(share * saved / self.scatter**2)

    def _stays(self) -> bool:
        """Whether ends and corners stay near the level."""
        if (np.abs(self.stress[[0, -1]] - self.level) > self._room).any():
            return False
        path = self._path
        inner = (path.rows > self.first) & (path.rows < self.last)
        room = WIDE * abs(self.level) + 4 * path.error[inner]
        return bool((np.abs(path.stress[inner] - self.level) <= room).all())

    def _pace(self, row: int, sense: int, level: float, reach: float) -> float | None:
        """Rate beyond an end, from its level to where a step from it is done; None when it never is."""
        step = max(STEP * abs(level), CLEAR * self._path.noise[row])
        beyond = self._all[row::sense]
        start, size = 1, 16
        while start < len(beyond):
            gone = np.flatnonzero(np.abs(beyond[start : start + size] - level) >= step)
            if len(gone):
                there = row + sense * (start + int(gone[0]))
                # A step at once is as fast as can be told.
                apart = max(abs(self._x[there] - self._x[row]), 1e-3 * reach, SHORTEST)
                return sense * float(self._all[there] - level) / apart
            start, size = start + size, 4 * size
        return None

    def _moving(self, sense: int, pace: float) -> bool:
        """Whether the stretch, read from one end (sense 1, or -1 for the other), begins with the move before it."""
        stress, x, noise = self.stress[::sense], sense * self.x[::sense], self.noise[::sense]
        way = np.sign(pace)
        own = slice(0, max(3, len(stress) // 4))
        if way * (stress[0] - np.median(stress[own])) < -3 * self.scatter:
            return True
        spread = np.sum((x[own] - x[own].mean()) ** 2)
        if spread == 0:
            return False
        line = fit_line(x[own], stress[own], noise[own])
        slope = way * (line.end - line.start) / np.ptp(x[own])
        return bool(slope - SLOW * abs(pace) > 1.5 * self.scatter / np.sqrt(spread))

    def _through(self, before: float | None, after: float | None, reach: float) -> float:
        """Least sum of squares when the stress goes on at the pace before, and from some place on at the one after."""
        turns = TURNS if before is not None and after is not None else TURNS[:1]
        before, after = after if before is None else before, before if after is None else after
        if len(self.stress) == 2 and self.stress[0] == self.stress[1]:
            # There might always be a turn between two readings, but not between those of a table of loads.
            turns = turns[[0, -1]]
        # Slow is only what goes on the same way: a turn has the pace of its moves.
        paces = PACES if before * after > 0 else PACES[-1:]
        off = self.x - (self.x[0] + turns * reach)[:, None]
        shape = np.where(off < 0, before * off, after * off)
        rest = self.stress - paces[:, None, None] * shape
        return float(np.sum((rest - rest.mean(axis=-1, keepdims=True)) ** 2, axis=-1).min())


def _best_apart(found: list[tuple[int, int, float]]) -> list[tuple[int, int]]:
    """First and last row of those stretches (last, first, gain) without a common row that gain most together."""
    found.sort()
    ends = [last for last, _, _ in found]
    best, steps = [0.0], []
    for number, (_, first, gain) in enumerate(found):
        before = bisect_left(ends, first, 0, number)
        taken = best[before] + gain > best[-1]
        best.append(best[before] + gain if taken else best[-1])
        steps.append(before if taken else None)
    chosen, number = [], len(found)
    while number > 0:
        before = steps[number - 1]
        if before is None:
            number -= 1
            continue
        chosen.append((found[number - 1][1], found[number - 1][0]))
        number = before
    return chosen[::-1]
