"""The path of stress through a test, freed of noise: a line from corner to corner."""

from dataclasses import dataclass

import numpy as np

from grus.recording.noise import stress_noise
from grus.recording.pieces import fit_line, straight_pieces

LEVEL_PRICE, LINE_PRICE = 2.0, 3.0
"""Chi-square that a further piece must save, over the logarithm of the number of readings: by the Bayesian information
criterion, for the one or two numbers of the piece and for its place."""
STEP = 0.08
"""Least change of stress that is a move, as a share of the stress."""
CLEAR = 5.0
"""The same in standard errors, where noise is large."""


MOST_POINTS = 2000
"""Readings above this number are averaged in groups to find the pieces."""


@dataclass(frozen=True)
class Move:
    """Stress from `start` to `end` [Pa] between two rows, one way."""

    first: int
    last: int
    start: float
    end: float


@dataclass(frozen=True)
class StressPath:
    """Corners of the path: rows (k,), not falling, stress (k,) [Pa] and its standard error (k,).

    pieces: first and last row (m, 2) of each straight piece, at which the corners are. noise: standard deviation (n,)
    of each reading of stress [Pa].
    """

    rows: np.ndarray
    stress: np.ndarray
    error: np.ndarray
    pieces: np.ndarray
    noise: np.ndarray

    @classmethod
    def of(cls, stress: np.ndarray, x: np.ndarray) -> "StressPath":
        """Of readings of stress (n,) [Pa] at places x (n,), not falling."""
        noise = stress_noise(stress, x)
        pieces = _pieces(stress, x, noise)
        corners = []
        for first, last in pieces:
            own = slice(first, last + 1)
            line = fit_line(x[own], stress[own], noise[own])
            corners.append((first, line.start, line.start_error))
            if last > first:
                corners.append((last, line.end, line.end_error))
        rows, values, errors = zip(*corners)
        return cls(np.array(rows), np.array(values), np.array(errors), pieces, noise)

    def at(self, rows: np.ndarray | int) -> np.ndarray:
        """Stress [Pa] at rows."""
        return np.interp(rows, self.rows, self.stress)

    def moves(
        self, first: int, last: int, start: float | None = None, end: float | None = None
    ) -> list[Move]:
        """Moves from row to row, each by a step at least and opposite to the one before; none when nothing moves.

        start, end: stress [Pa] at both rows where it is known better than from the path.
        """
        inner = (self.rows > first) & (self.rows < last)
        rows = np.concatenate([[first], self.rows[inner], [last]])
        stress = np.concatenate(
            [
                [self.at(first) if start is None else start],
                self.stress[inner],
                [self.at(last) if end is None else end],
            ]
        )
        error = np.concatenate(
            [
                [self.noise[first] if start is None else 0.0],
                self.error[inner],
                [self.noise[last] if end is None else 0.0],
            ]
        )
        corners = _turns(stress, np.maximum(STEP * np.abs(stress), CLEAR * error))
        return [
            Move(int(rows[a]), int(rows[b]), float(stress[a]), float(stress[b]))
            for a, b in zip(corners, corners[1:])
        ]


def group_size(count: int) -> int:
    """How many of so many readings are averaged to find the pieces."""
    return -(-count // MOST_POINTS)


def _pieces(stress: np.ndarray, x: np.ndarray, noise: np.ndarray) -> np.ndarray:
    """First and last row (m, 2) of the straight pieces of stress (n,) at places x (n,)."""
    size = group_size(len(stress))
    starts = np.arange(0, len(stress), size)
    counts = np.diff(np.append(starts, len(stress)))
    means = [np.add.reduceat(values, starts) / counts for values in (x, stress, noise)]
    price = np.log(len(starts))
    found = straight_pieces(
        means[0],
        means[1],
        means[2] / np.sqrt(counts),
        LEVEL_PRICE * price,
        LINE_PRICE * price,
    )
    bounds = np.array([starts[first] for first, _ in found] + [len(stress)])
    if size > 1:
        bounds = _refined(stress, x, noise, bounds, size)
    return np.column_stack([bounds[:-1], bounds[1:] - 1])


def _refined(
    stress: np.ndarray, x: np.ndarray, noise: np.ndarray, bounds: np.ndarray, size: int
) -> np.ndarray:
    """The first rows of pieces (and the end), each moved by up to `size` rows to where both its lines fit best."""
    moved = bounds.copy()
    for number in range(1, len(bounds) - 1):
        before, here, after = moved[number - 1], bounds[number], bounds[number + 1]
        around = np.arange(max(here - size, before + 1), min(here + size, after - 1))
        if len(around) < 2:
            continue
        misfit = []
        # Readings of the group that may hold the bound belong to neither line yet.
        for first, last in (
            (before, max(here - size, before + 1)),
            (min(here + size, after - 1), after),
        ):
            own = slice(first, last)
            slope = _slope(x[own], stress[own]) if last - first > 2 else 0.0
            middle = stress[own].mean() + slope * (x[around] - x[own].mean())
            misfit.append(((stress[around] - middle) / noise[around]) ** 2)
        left = np.concatenate([[0.0], np.cumsum(misfit[0])])
        right = np.concatenate([np.cumsum(misfit[1][::-1])[::-1], [0.0]])
        moved[number] = around[0] + int(np.argmin(left + right))
    return moved


def _slope(x: np.ndarray, y: np.ndarray) -> float:
    off = x - x.mean()
    spread = float(off @ off)
    return float(off @ y) / spread if spread > 0 else 0.0


def _turns(stress: np.ndarray, step: np.ndarray) -> list[int]:
    """Indices between which the stress (k,) goes one way by a step (k,) at least; [0] when it does not."""
    corners, low, high, sense = [0], 0, 0, 0
    for here in range(1, len(stress)):
        low = here if stress[here] < stress[low] else low
        high = here if stress[here] > stress[high] else high
        falls = stress[high] - stress[here] > max(step[high], step[here])
        rises = stress[here] - stress[low] > max(step[low], step[here])
        if sense >= 0 and falls:
            corners += [high] if sense else []
            sense, low = -1, here
        elif sense <= 0 and rises:
            corners += [low] if sense else []
            sense, high = 1, here
    return [*corners, len(stress) - 1] if sense else [0]
