"""A growing number of events over x, whose rate is constant but for its breaks."""

import numpy as np
from scipy.special import xlogy
from scipy.stats import chi2
from scipy.stats import f as f_law

from grus.compression.breaks import GRID, PAIR_GRID
from grus.compression.loading import break_bounds

MOST = 60
"""Readings that are kept, spread evenly over x; what happened between them is counted together."""
TURNS = 60
"""Steps of the expectation-maximisation, which is exact at once but for steps that a break cuts."""


class Counts:
    """Events y counted up to x, for `find_breaks`: a Poisson process with a dispersion.

    The number of events between two readings has the mean rate * dx and a variance in proportion to
    it (events come in bursts); the dispersion is Pearson's, from the largest model, and at least
    that of single events, where y shows their size. A break is one where the rate grows.
    """

    def __init__(self, x: np.ndarray, y: np.ndarray) -> None:
        """x (n,) rising; y (n,) never falling, any unit."""
        least = _unit(y)
        if len(x) > MOST:
            kept = np.unique(np.searchsorted(x, np.linspace(x[0], x[-1], MOST)))
            x, y = x[kept], y[kept]
        self.x, self.start = x, float(y[0])
        self.events = np.diff(y)
        self.count = len(self.events)
        self.dispersion = 1.0
        self.dispersion = self._dispersion(least)

    @property
    def bounds(self) -> tuple[float, float]:
        return break_bounds(self.x)

    def line(self) -> float:
        return float(self._deviance(self._fitted(np.empty((1, 0)))[1])[0])

    def one(self, at: np.ndarray) -> np.ndarray:
        return self._growing(at[:, None])

    def two(self, first: np.ndarray, last: np.ndarray) -> np.ndarray:
        pairs = np.stack(np.meshgrid(first, last, indexing="ij"), axis=-1)
        between = np.searchsorted(self.x, pairs[..., 1], "right")
        room = between - np.searchsorted(self.x, pairs[..., 0]) >= 2
        best = np.full(room.shape, np.inf)
        best[room] = self._growing(pairs[room])
        return best

    def allowed(self, breaks: int, confidence: float) -> float:
        # The place where a rate jumps follows no chi-square law (Hinkley 1970, Yao 1987); the ratio
        # of F to chi-square makes up for the dispersion's being an estimate.
        jump = -2 * np.log1p(-np.sqrt(confidence))
        freedom = max(self.count - 1 - 2 * breaks, 1)
        ratio = f_law.ppf(confidence, 1, freedom) / chi2.ppf(confidence, 1)
        return float(jump * ratio)

    def slopes(self, places: tuple[float, ...]) -> tuple[float, np.ndarray, float]:
        """Number at the last place, the rates (b + 1,) from place to place, and 0: they jump."""
        rate = self._fitted(np.array([places]))[0][0]
        edges = np.array([self.x[0], *places])
        return self.start + float(rate[:-1] @ np.diff(edges)), rate, 0.0

    def _growing(self, places: np.ndarray) -> np.ndarray:
        rate, mean = self._fitted(places)
        return np.where(rate[:, -1] > rate[:, -2], self._deviance(mean), np.inf)

    def _deviance(self, mean: np.ndarray) -> np.ndarray:
        """-2 log quasi-likelihood (m,) of the means (m, n)."""
        expected = np.where(self.events > 0, mean, 1.0)
        gain = xlogy(self.events, self.events / expected) - self.events + mean
        return 2 * gain.sum(axis=-1) / self.dispersion

    def _fitted(self, places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Rates (m, b + 1) and means (m, n) of largest likelihood for the breaks (m, b)."""
        outer = np.full((len(places), 1), np.inf)
        low = np.concatenate([-outer, places], axis=1)[:, :, None]
        high = np.concatenate([places, outer], axis=1)[:, :, None]
        length = np.clip(np.minimum(self.x[1:], high) - np.maximum(self.x[:-1], low), 0.0, None)
        total = length.sum(axis=2)
        rate = (length * self.events / np.diff(self.x)).sum(axis=2) / total
        for _ in range(TURNS if places.size else 0):
            mean = np.einsum("mb,mbn->mn", rate, length)
            ratio = np.divide(self.events, mean, out=np.zeros_like(mean), where=self.events > 0)
            rate = rate * np.einsum("mn,mbn->mb", ratio, length) / total
        return rate, np.einsum("mb,mbn->mn", rate, length)

    def _dispersion(self, least: float) -> float:
        number = 2 if self.count >= 9 else 1
        places = np.linspace(*self.bounds, PAIR_GRID if number == 2 else GRID)
        if number == 2:
            deviance = self.two(places, places)
            best = np.unravel_index(deviance.argmin(), deviance.shape)
        else:
            deviance = self.one(places)
            best = (deviance.argmin(),)
        chosen = places[list(best)] if np.isfinite(deviance.min()) else np.empty(0)
        mean = self._fitted(chosen[None, :])[1][0]
        likely = mean > 1e-9 * mean.max()
        freedom = max(int(likely.sum()) - 1 - 2 * len(chosen), 1)
        square = (self.events - mean)[likely] ** 2 / mean[likely]
        return max(float(square.sum()) / freedom, least)


def _unit(y: np.ndarray) -> float:
    """Size of a single event: 1 in whole numbers, 1/n in shares of n; next to 0 if none shows."""
    if not np.mod(y, 1).any():
        return 1.0
    smallest = np.diff(y)[np.diff(y) > 0].min()
    multiple = y / smallest
    exact = np.abs(multiple - np.round(multiple)).max() < 1e-6
    return float(smallest if exact else 1e-9 * (y[-1] - y[0]))
