"""Breaks of a line: how many, where, and how surely."""

from dataclasses import dataclass
from typing import Protocol

import numpy as np

PRICE_OF_A_BREAK = 3
"""Parameters that a break counts for: its slope, and twice its place, which is chosen among many
(Ninomiya 2005; Hall, Osborn & Sakkas 2013)."""
GRID, PAIR_GRID, PASSES = 161, 41, 3


class Curve(Protocol):
    """What a curve with a noise law has to tell; deviance is -2 log likelihood.

    count: number of readings. bounds: lowest and highest place of a break.
    line(): deviance without a break. one(at (k,)): with one break, (k,). two(first (j,), last
    (k,)): with two, (j, k). Infinite where the last break bends the wrong way or has no room.
    slopes(places): value at the last break, slopes (b + 1,) from break to break, their width.
    allowed(breaks, confidence): rise of the deviance at the ends of the interval of the last break.
    """

    count: int
    bounds: tuple[float, float]

    def line(self) -> float:
        ...

    def one(self, at: np.ndarray) -> np.ndarray:
        ...

    def two(self, first: np.ndarray, last: np.ndarray) -> np.ndarray:
        ...

    def allowed(self, breaks: int, confidence: float) -> float:
        ...

    def slopes(self, places: tuple[float, ...]) -> tuple[float, np.ndarray, float]:
        ...


@dataclass(frozen=True)
class Breaks:
    """Breaks found in a curve: places (0, 1 or 2), interval of the last, criterion by number.

    criterion: Bayesian information criterion without, with one, and with two breaks.
    """

    places: tuple[float, ...]
    interval: tuple[float, float] | None
    criterion: tuple[float, ...]


def find_breaks(curve: Curve, most: int, confidence: float) -> Breaks:
    """The number of breaks, at most `most` (1 or 2), with the lowest criterion, and their places.

    The interval of the last break holds the places whose profile deviance rises by no more than
    what the noise allows at this confidence; it ends at the bounds of the search at the latest.
    """
    grids = [np.linspace(*curve.bounds, points) for points in (GRID, PAIR_GRID)]
    deviance = [curve.line(), curve.one(grids[0]).min()]
    if most == 2:
        deviance.append(curve.two(grids[1], grids[1]).min())
    price = np.log(curve.count)
    criterion = tuple(
        float(value + (2 + PRICE_OF_A_BREAK * number) * price)
        for number, value in enumerate(deviance)
    )
    number = int(np.argmin(criterion))
    if number == 0:
        return Breaks((), None, criterion)
    first, last = _refined(curve, number, grids[number - 1], curve.allowed(number, confidence))
    places = (last.best,) if number == 1 else (first, last.best)
    return Breaks(places, last.interval, criterion)


@dataclass(frozen=True)
class _Profile:
    """Deviance (k,) at rising places (k,) of a break."""

    place: np.ndarray
    deviance: np.ndarray
    allowed: float

    @property
    def best(self) -> float:
        return float(self.place[self.deviance.argmin()])

    @property
    def around(self) -> tuple[int, int]:
        """Indices of the places just outside the interval, or of the ends of the search."""
        inside = np.flatnonzero(self.deviance <= self.deviance.min() + self.allowed)
        return max(inside[0] - 1, 0), min(inside[-1] + 1, len(self.place) - 1)

    @property
    def interval(self) -> tuple[float, float]:
        """Where the deviance crosses the limit, by interpolation between places."""
        limit = self.deviance.min() + self.allowed
        low, high = self.around
        return self._crossing(low, low + 1, limit), self._crossing(high, high - 1, limit)

    def _crossing(self, outer: int, inner: int, limit: float) -> float:
        above, below = self.deviance[outer] - limit, limit - self.deviance[inner]
        share = below / (above + below) if 0 < above < np.inf else float(above <= 0)
        return float(self.place[inner] + share * (self.place[outer] - self.place[inner]))


def _refined(curve: Curve, number: int, grid: np.ndarray, allowed: float) -> tuple[float, _Profile]:
    """Place of the first of two breaks, and profile of the last, on ever finer grids."""
    firsts, lasts = grid, grid
    first = np.nan
    for _ in range(PASSES):
        if number == 1:
            profile = _Profile(lasts, curve.one(lasts), allowed)
        else:
            deviance = curve.two(firsts, lasts)
            profile = _Profile(lasts, deviance.min(axis=0), allowed)
            nearest = int(np.unravel_index(deviance.argmin(), deviance.shape)[0])
            first = float(firsts[nearest])
            beside = firsts[max(nearest - 1, 0)], firsts[min(nearest + 1, len(firsts) - 1)]
            firsts = np.union1d(grid, np.linspace(*beside, PAIR_GRID // 2))
        low, high = profile.around
        lasts = np.union1d(np.linspace(lasts[low], lasts[high], len(grid)), [profile.best])
    return first, profile
