"""Readings as straight pieces: the partition with the least misfit and a price for each piece."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Line:
    """Line by weighted least squares: values at its two ends, and their standard errors."""

    start: float
    end: float
    start_error: float
    end_error: float


def straight_pieces(
    x: np.ndarray, y: np.ndarray, noise: np.ndarray, level: float, line: float
) -> list[tuple[int, int]]:
    """First and last index of each piece of the best partition of readings y (n,) at x (n,), not falling.

    noise: standard deviation (n,) of each reading, > 0. level, line: what a further piece must save in chi-square, as
    a constant and as a line. Pieces need not meet. Optimal partitioning (Jackson et al. 2005) with the pruning of
    PELT (Killick, Fearnhead & Eckley 2012), which loses nothing.
    """
    weight = noise**-2.0
    best, before = np.empty(len(y)), np.empty(len(y), dtype=int)
    starts = np.empty(0, dtype=int)
    # Of each candidate for the start of the last piece: price so far, and the moments of the piece. The moments are
    # carried on reading by reading (Welford), since differences of sums lose all digits where times span decades.
    state = np.empty((7, 0))
    for end in range(len(y)):
        born = np.zeros((7, 1))
        born[0] = best[end - 1] if end else 0.0
        state, starts = np.hstack([state, born]), np.append(starts, end)
        so_far, mass, mean_x, mean_y, xx, xy, yy = state
        dx, dy = x[end] - mean_x, y[end] - mean_y
        share = weight[end] / (mass + weight[end])
        xx += (factor := mass * share) * dx * dx
        xy += factor * dx * dy
        yy += factor * dy * dy
        mean_x += share * dx
        mean_y += share * dy
        mass += weight[end]
        saved = np.divide(xy * xy, xx, out=np.zeros_like(xx), where=xx > 0)
        sloping = np.maximum(yy - saved, 0.0)
        total = so_far + np.minimum(yy + level, sloping + line)
        chosen = int(total.argmin())
        best[end], before[end] = total[chosen], starts[chosen]
        kept = so_far + sloping + level - line <= best[end]
        state, starts = state[:, kept], starts[kept]
    pieces = []
    end = len(y) - 1
    while end >= 0:
        pieces.append((int(before[end]), end))
        end = int(before[end]) - 1
    return pieces[::-1]


def fit_line(x: np.ndarray, y: np.ndarray, noise: np.ndarray) -> Line:
    """Line through readings y (n,) at x (n,), of standard deviation `noise` (n,); constant where all x are equal."""
    weight = noise**-2.0
    mean_x, mean_y = np.average(x, weights=weight), np.average(y, weights=weight)
    ends = x[[0, -1]] - mean_x
    spread = np.sum(weight * (x - mean_x) ** 2)
    slope = np.sum(weight * (x - mean_x) * (y - mean_y)) / spread if spread > 0 else 0.0
    lever = ends**2 / spread if spread > 0 else np.zeros(2)
    # A line through two readings is no worse known at them than they are.
    errors = np.minimum(np.sqrt(1 / weight.sum() + lever), noise[[0, -1]])
    return Line(*map(float, mean_y + slope * ends), *map(float, errors))
