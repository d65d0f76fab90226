"""Weibull regression of strength on diameter, by profile likelihood."""

from __future__ import annotations

import numpy as np
from scipy.special import softmax

from grus.statistics.likelihood import best_location, log_likelihood, maximum_likelihood
from grus.statistics.likelihood_region import crossing


class SizeRegression:
    """y = u + b x + w/m with y = ln(strength), x = ln(diameter), w of the smallest extreme values.

    The likelihood is concave in (m, m u, m b), so every profile below has one maximum.

    modulus, slope, location: estimates of m, b, u. peak: log-likelihood there (density of y).
    """

    def __init__(self, logs: np.ndarray, broken: np.ndarray, log_diameters: np.ndarray):
        """logs (n,), broken (n,) bool, log_diameters (n,) with at least two different values."""
        self._y = logs
        self._broken = broken
        self._x = log_diameters
        self._count = broken.sum()
        start = self._least_squares()
        modulus, _ = self._at_slope(start)
        self._step = 1.0 / (modulus * log_diameters[broken].std() * np.sqrt(self._count))
        side = 1.0 if self._slope_score(start) > 0.0 else -1.0
        self.slope = crossing(lambda b: -side * self._slope_score(b), start, side * self._step)
        self.modulus, self.location = self._at_slope(self.slope)
        self.peak = log_likelihood(self._residuals(self.slope), broken, self.modulus, self.location)

    def slope_interval(self, allowed: float) -> tuple[float, float]:
        """Slopes whose profile log-likelihood is lower than the peak by ``allowed``."""

        def excess(slope: float) -> float:
            residuals = self._residuals(slope)
            return (
                self.peak
                - allowed
                - log_likelihood(residuals, self._broken, *self._at_slope(slope))
            )

        return (
            crossing(excess, self.slope, -self._step),
            crossing(excess, self.slope, self._step),
        )

    def modulus_interval(self, allowed: float) -> tuple[float, float]:
        """Moduli whose profile log-likelihood is lower than the peak by ``allowed``."""

        def excess(log_modulus: float) -> float:
            return self.peak - allowed - self._at_modulus(float(np.exp(log_modulus)))

        centre = np.log(self.modulus)
        ends = (crossing(excess, centre, step) for step in (-0.1, 0.1))
        low, high = (float(np.exp(end)) for end in ends)
        return low, high

    def constrained(self, dimension: int) -> float:
        """Largest log-likelihood under slope = -dimension / modulus."""

        def score(log_modulus: float) -> float:
            m = np.exp(log_modulus)
            weights = softmax(m * self._y + dimension * self._x)
            return (
                m * (self._y[self._broken].sum() - self._count * (weights @ self._y)) + self._count
            )

        centre = np.log(self.modulus)
        side = 1.0 if score(centre) > 0.0 else -1.0
        modulus = float(np.exp(crossing(lambda x: -side * score(x), centre, 0.1 * side)))
        residuals = self._residuals(-dimension / modulus)
        location = best_location(residuals, self._broken, modulus)
        return log_likelihood(residuals, self._broken, modulus, location)

    def _residuals(self, slope: float) -> np.ndarray:
        return self._y - slope * self._x

    def _at_slope(self, slope: float) -> tuple[float, float]:
        return maximum_likelihood(self._residuals(slope), self._broken)

    def _at_modulus(self, modulus: float) -> float:
        """Profile log-likelihood at a given modulus: best m b, then best location."""

        def score(product: float) -> float:
            weights = softmax(modulus * self._y - product * self._x)
            return self._x[self._broken].mean() - weights @ self._x

        centre = modulus * self.slope
        side = 1.0 if score(centre) < 0.0 else -1.0
        product = crossing(lambda p: side * score(p), centre, 0.1 * side)
        residuals = self._residuals(product / modulus)
        location = best_location(residuals, self._broken, modulus)
        return log_likelihood(residuals, self._broken, modulus, location)

    def _slope_score(self, slope: float) -> float:
        """Derivative of the profile log-likelihood by the slope, divided by the modulus."""
        residuals = self._residuals(slope)
        modulus, _ = maximum_likelihood(residuals, self._broken)
        weights = softmax(modulus * residuals)
        return float(self._count * (weights @ self._x) - self._x[self._broken].sum())

    def _least_squares(self) -> float:
        slope, _ = np.polyfit(self._x[self._broken], self._y[self._broken], 1)
        return float(slope)
