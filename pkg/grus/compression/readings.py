"""A measured curve, straight but for its breaks, with noise of two kinds."""

import numpy as np
from scipy.linalg import cholesky, solve_triangular
from scipy.stats import f as f_law

MOST = 200
"""Readings that are kept; more are averaged over equal steps of x."""
WANDER = np.concatenate([[0.0], 10.0 ** np.arange(-2.0, 4.5, 0.5)])
"""Ratios tried of the variance of the wander over the whole range to that of a reading."""
FINEST = 1e-6
"""Smallest noise of a reading, as a share of the range of all; keeps exact data harmless."""


class Readings:
    """Readings y at x with Gaussian noise, for `find_breaks`.

    Noise is independent from reading to reading, plus a wander (Brownian in x), which stands for
    breakage in bursts and for bends that straight lines do not follow. The ratio of both is chosen
    by likelihood, anew for every line that is tried. Without the wander, intervals from a dense
    record would be far too narrow.
    """

    def __init__(
        self, x: np.ndarray, y: np.ndarray, sense: int, widths: tuple[float, ...] = (0.0,)
    ) -> None:
        """x (n,) rising, y (n,); a break is one where the slope grows (sense 1) or falls (-1).

        widths: w of a break, in x, of which the best is taken: the slope goes over with
        1 / (1 + exp(-(x - place)/w)), so that nine tenths of it change within 6 w. 0 is a kink.
        """
        self.x, self.y = _averaged(x, y)
        self.count = len(self.x)
        self.bounds = (float(self.x[1]), float(self.x[-3]))
        self._sense = sense
        self._scale = np.ptp(self.y) or 1.0
        place = (self.x - self.x[0]) / (self.x[-1] - self.x[0])
        wander = np.minimum.outer(place, place)
        roots = [cholesky(np.eye(self.count) + ratio * wander, lower=True) for ratio in WANDER]
        self._noise = [(root, 2 * np.log(np.diag(root)).sum()) for root in roots]
        self._laws = [(width, *noise) for width in widths for noise in self._noise]
        self._straight = np.stack([np.ones(self.count), place], axis=1)

    def deviance(self, basis: np.ndarray) -> float:
        """Of the best sum of the columns of `basis` (n, p)."""
        return min(
            self._deviance(_outside(root, basis, self.y / self._scale)[0], size)
            for root, size in self._noise
        )

    def line(self) -> float:
        return float(self.deviance(self._straight))

    def one(self, at: np.ndarray) -> np.ndarray:
        best = np.full(len(at), np.inf)
        for width, root, size in self._laws:
            rest, bends, along = self._bends(root, width, at)
            deviance = self._deviance(rest - along**2 / (bends**2).sum(axis=0), size)
            best = np.where(self._sense * along > 0, np.minimum(best, deviance), best)
        return best

    def two(self, first: np.ndarray, last: np.ndarray) -> np.ndarray:
        best = np.full((len(first), len(last)), np.inf)
        room = np.searchsorted(self.x, last) - np.searchsorted(self.x, first, "right")[:, None] >= 2
        for width, root, size in self._laws:
            rest, bends, along = self._bends(root, width, np.concatenate([first, last]))
            product = bends.T @ bends
            j, k = np.arange(len(first))[:, None], len(first) + np.arange(len(last))[None, :]
            square = product[j, j] * product[k, k] - product[j, k] ** 2
            square = np.where(room, square, 1.0)
            opening = (along[j] * product[k, k] - along[k] * product[j, k]) / square
            closing = (along[k] * product[j, j] - along[j] * product[j, k]) / square
            deviance = self._deviance(rest - opening * along[j] - closing * along[k], size)
            best = np.where(room & (self._sense * closing > 0), np.minimum(best, deviance), best)
        return best

    def allowed(self, breaks: int, confidence: float) -> float:
        freedom = max(self.count - 2 - 2 * breaks, 1)
        return float(self.count * np.log1p(f_law.ppf(confidence, 1, freedom) / freedom))

    def slopes(self, places: tuple[float, ...]) -> tuple[float, np.ndarray, float]:
        """Value at the last place on the lines, their slopes (b + 1,), and the width of the breaks.

        By least squares.
        """
        fits = []
        for width, root, size in self._laws:
            columns = [np.ones(self.count), self.x - places[-1]]
            columns += [bend(self.x - place, width) for place in places]
            rest = _outside(root, np.stack(columns, axis=1), self.y / self._scale)[0]
            fits.append((self._deviance(rest, size), width, root, np.stack(columns, axis=1)))
        _, width, root, basis = min(fits, key=lambda fit: fit[0])
        white = solve_triangular(root, np.column_stack([basis, self.y]), lower=True)
        weight = np.linalg.lstsq(white[:, :-1], white[:, -1], rcond=None)[0]
        level = weight[0] + sum(w * (places[-1] - p) for w, p in zip(weight[2:], places))
        return float(level), np.cumsum(weight[1:]), width

    def _bends(
        self, root: np.ndarray, width: float, at: np.ndarray
    ) -> tuple[float, np.ndarray, np.ndarray]:
        """What the straight line leaves of y (squared), of the bends (n, k), and their product."""
        bends = bend(self.x[:, None] - at, width) / (self.x[-1] - self.x[0])
        rest, bends, left = _outside(root, self._straight, self.y / self._scale, bends)
        return rest, bends, bends.T @ left

    def _deviance(self, rest: np.ndarray | float, size: float) -> np.ndarray | float:
        """-2 log likelihood from the sum of squares left, the variance chosen by likelihood."""
        return self.count * np.log(np.maximum(rest, 0.0) / self.count + FINEST**2) + size


def bend(x: np.ndarray, width: float) -> np.ndarray:
    """A line of slope 0 that goes over into one of slope 1 at x = 0, within about 6 widths."""
    return width * np.logaddexp(0.0, x / width) if width else np.maximum(x, 0.0)


def _outside(
    root: np.ndarray, basis: np.ndarray, y: np.ndarray, others: np.ndarray | None = None
) -> tuple[float, np.ndarray, np.ndarray]:
    """Sum of squares of y, the other columns, and y itself, whitened and cleared of the basis."""
    columns = np.column_stack([basis, y] if others is None else [basis, y, others])
    white = solve_triangular(root, columns, lower=True)
    known, white = white[:, : basis.shape[1]], white[:, basis.shape[1] :]
    frame = np.linalg.qr(known)[0]
    white = white - frame @ (frame.T @ white)
    return float(white[:, 0] @ white[:, 0]), white[:, 1:], white[:, 0]


def _averaged(x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Means of the readings over at most MOST equal steps of x, without those that are empty."""
    if len(x) <= MOST:
        return x, y
    step = np.minimum((MOST * (x - x[0]) / (x[-1] - x[0])).astype(np.int64), MOST - 1)
    number = np.bincount(step)
    used = number > 0
    sums = (np.bincount(step, weights=column)[used] for column in (x, y))
    return tuple(total / number[used] for total in sums)
