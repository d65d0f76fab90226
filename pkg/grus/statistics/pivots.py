"""Parameter-free (pivotal) quantities of complete Weibull samples, by seeded simulation.

Thoman, Bain & Antle (1969), Technometrics 11:445-460: with estimates m^, s^ from n values of a
Weibull law (m, s) the distributions of m^/m and m^ ln(s^/s) depend on n alone, and so does that of
the Anderson-Darling distance to the fitted law. One simulated table per n therefore gives exact
confidence intervals and an exact p-value, up to the scatter of the simulation.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from grus.statistics.anderson_darling import anderson_darling
from grus.statistics.likelihood import maximum_likelihood_rows

CHUNK = 500_000  # values held at once


@dataclass(frozen=True)
class Pivots:
    """Simulated pivots of N samples of n values, each (N,).

    modulus: m^/m. location: m^ ln(s^/s). distance: A^2 of the sample to its own fit.
    """

    modulus: np.ndarray
    location: np.ndarray
    distance: np.ndarray

    def p_value(self, distance: float) -> float:
        """Share of Weibull samples that lie at least as far from their fit."""
        return float((1 + np.sum(self.distance >= distance)) / (1 + self.distance.size))


class PivotalIntervals:
    """Exact intervals of one fitted sample; the same form as ``LikelihoodRegion``."""

    def __init__(self, pivots: Pivots, modulus: float, location: float, confidence: float):
        """``modulus`` and ``location`` as estimated, ``location`` = ln(s^)."""
        self.pivots = pivots
        self.modulus = modulus
        self.location = location
        self.levels = np.array([0.5 * (1.0 - confidence), 0.5 * (1.0 + confidence)])

    def modulus_interval(self) -> tuple[float, float]:
        """Interval (low, high) of the modulus."""
        low, high = self.modulus / np.quantile(self.pivots.modulus, self.levels[::-1])
        return float(low), float(high)

    def quantile_interval(self, reduced: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Intervals (low, high) of u + reduced / m; reduced (k,), zero for ln(sigma_0) itself.

        Pivot: m^ ((u^ + g/m^) - (u + g/m)) = m^ (u^ - u) + g (1 - m^/m), g = ``reduced``.
        """
        g = np.atleast_1d(reduced)[:, None]
        pivot = self.pivots.location + g * (1.0 - self.pivots.modulus)
        high, low = self.location + (g.T - np.quantile(pivot, self.levels, axis=1)) / self.modulus
        return low, high


@lru_cache(maxsize=64)
def simulate_pivots(n: int, seed: int) -> Pivots:
    """Pivots of samples of n values: 40 000 of them up to n = 150, 4000 from n = 1500."""
    count = int(np.clip(6_000_000 // n, 4_000, 40_000))
    generator = np.random.Generator(
        np.random.PCG64(np.random.SeedSequence(entropy=seed, spawn_key=(n,)))
    )
    rows = max(1, CHUNK // n)
    parts = [_simulate(generator, min(rows, count - start), n) for start in range(0, count, rows)]
    arrays = [np.concatenate(part) for part in zip(*parts)]
    for array in arrays:
        array.flags.writeable = False  # the table is shared by all callers
    return Pivots(*arrays)


def _simulate(generator: np.random.Generator, count: int, n: int) -> tuple[np.ndarray, ...]:
    uniform = np.maximum(generator.random((count, n)), 2.0**-54)  # ln(0) must not occur
    logs = np.sort(np.log(-np.log1p(-uniform)), axis=1)
    modulus, location = maximum_likelihood_rows(logs)
    reduced = modulus[:, None] * (logs - location[:, None])
    return modulus, modulus * location, anderson_darling(reduced)
