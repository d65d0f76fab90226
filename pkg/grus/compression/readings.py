"""A measured curve, straight but for its breaks, with noise of two kinds."""

from collections.abc import Iterator

import numpy as np
from scipy.linalg import cholesky, solve_triangular
from scipy.stats import f as f_law

from grus.compression.loading import break_bounds

MOST, FINE = 120, 1200
"""Readings that are kept; more are averaged over equal steps of x, and so are the lines, which are
drawn with the second number of points."""
WANDER = np.concatenate([[0.0], 10.0 ** np.arange(-2.0, 4.5, 0.5)])
"""Ratios tried of the variance of the wander over the whole range to that of a reading."""
FOR_TWO = 15
"""Readings without which two breaks, with their six parameters, follow the noise."""
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
        if len(x) > FINE:
            x, y = (_averaged(column, *_steps(x, FINE)) for column in (x, y))
        self._fine, self._steps = x, _steps(x, MOST) if len(x) > MOST else None
        self.x, self.y = self._coarse(x), self._coarse(y)
        self.count = len(self.x)
        self._sense = sense
        self._scale = np.ptp(self.y) or 1.0
        place = (self.x - self.x[0]) / (self.x[-1] - self.x[0])
        wander = np.minimum.outer(place, place)
        roots = [cholesky(np.eye(self.count) + ratio * wander, lower=True) for ratio in WANDER]
        self._noise = [(root, 2 * np.log(np.diag(root)).sum()) for root in roots]
        self._widths = widths
        self._straight = np.stack([np.ones(self.count), place], axis=1)

    def deviance(self, basis: np.ndarray) -> float:
        """Of the best sum of the columns of `basis` (n, p)."""
        return min(
            self._deviance(_outside(root, basis, self.y / self._scale)[0], size)
            for root, size in self._noise
        )

    @property
    def bounds(self) -> tuple[float, float]:
        return break_bounds(self.x)

    def line(self) -> float:
        return float(self.deviance(self._straight))

    def one(self, at: np.ndarray) -> np.ndarray:
        best = np.full(len(at), np.inf)
        for rest, bends, along, size in self._bends(at):
            deviance = self._deviance(rest - along**2 / (bends**2).sum(axis=0), size)
            best = np.where(self._sense * along > 0, np.minimum(best, deviance), best)
        return best

    def two(self, first: np.ndarray, last: np.ndarray) -> np.ndarray:
        best = np.full((len(first), len(last)), np.inf)
        room = np.searchsorted(self.x, last) - np.searchsorted(self.x, first, "right")[:, None] >= 2
        room &= self.count >= FOR_TWO
        j, k = np.arange(len(first))[:, None], len(first) + np.arange(len(last))[None, :]
        for rest, bends, along, size in self._bends(np.concatenate([first, last])):
            product = bends.T @ bends
            square = np.where(room, product[j, j] * product[k, k] - product[j, k] ** 2, 1.0)
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

        By generalised least squares.
        """
        fits = []
        for width in self._widths:
            columns = [np.ones(self.count), self.x - places[-1]]
            columns += [self._coarse(bend(self._fine - place, width)) for place in places]
            basis = np.stack(columns, axis=1)
            weight, rest, size, _ = self._solved(basis)
            fits.append((self._deviance(rest, size), width, weight))
        _, width, weight = min(fits, key=lambda fit: fit[0])
        level = weight[0] + sum(w * (places[-1] - p) for w, p in zip(weight[2:], places))
        return float(level), np.cumsum(weight[1:]), width

    def slope(self) -> tuple[float, float]:
        """Slope of the straight line, and its standard error."""
        weight, rest, _, spread = self._solved(self._straight)
        reach = self.x[-1] - self.x[0]
        variance = spread[1, 1] * rest * self._scale**2 / (self.count - 2)
        return float(weight[1] / reach), float(np.sqrt(variance) / reach)

    def _solved(self, basis: np.ndarray) -> tuple[np.ndarray, float, float, np.ndarray]:
        """Weights (p,) of the columns, and under their noise: squares left, size, spread (p, p)."""
        fits = []
        for root, size in self._noise:
            white = solve_triangular(root, np.column_stack([basis, self.y]), lower=True)
            columns, y = white[:, :-1], white[:, -1]
            weight = np.linalg.lstsq(columns, y, rcond=None)[0]
            rest = float(((y - columns @ weight) ** 2).sum()) / self._scale**2
            fits.append((self._deviance(rest, size), weight, rest, size, columns))
        _, weight, rest, size, columns = min(fits, key=lambda fit: fit[0])
        return weight, rest, size, np.linalg.inv(columns.T @ columns)

    def _bends(self, at: np.ndarray) -> Iterator[tuple[float, np.ndarray, np.ndarray, float]]:
        """For each width and noise, whitened and cleared of the straight line: squares of y, bends
        (n, k), products of both (k,); and the size of the noise."""
        for width in self._widths:
            bends = self._coarse(bend(self._fine[:, None] - at, width)) / (self.x[-1] - self.x[0])
            for root, size in self._noise:
                rest, clear, left = _outside(root, self._straight, self.y / self._scale, bends)
                yield rest, clear, clear.T @ left, size

    def _coarse(self, columns: np.ndarray) -> np.ndarray:
        """Columns (n, ...) at the fine points, averaged to the readings that are kept."""
        return columns if self._steps is None else _averaged(columns, *self._steps)

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


def _steps(x: np.ndarray, most: int) -> tuple[np.ndarray, np.ndarray]:
    """Index of the first of the rising points x (n,) in each of so many equal steps, and how many
    points it holds; without the steps that hold none."""
    step = np.minimum((most * (x - x[0]) / (x[-1] - x[0])).astype(np.int64), most - 1)
    return np.unique(step, return_index=True, return_counts=True)[1:]


def _averaged(columns: np.ndarray, first: np.ndarray, number: np.ndarray) -> np.ndarray:
    sums = np.add.reduceat(columns, first, axis=0)
    return (sums.T / number).T
