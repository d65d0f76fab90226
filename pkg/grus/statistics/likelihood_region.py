"""Likelihood-ratio confidence region of modulus and location, for censored samples."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.optimize import brentq
from scipy.special import lambertw, logsumexp
from scipy.stats import chi2

POINTS = 1001


class LikelihoodRegion:
    """{(m, u): 2 (l_max - l(m, u)) <= chi2_1(confidence)} of one sample.

    The extremes of a function of (m, u) over its boundary are the profile-likelihood interval of
    that function. The intervals have the same form as ``PivotalIntervals``.
    """

    def __init__(self, logs: np.ndarray, broken: np.ndarray, modulus: float, confidence: float):
        """logs (n,), broken (n,) bool, ``modulus`` the maximum-likelihood estimate."""
        count = broken.sum()
        allowed = 0.5 * chi2.ppf(confidence, 1)

        def profile(log_modulus):
            m = np.exp(log_modulus)
            spread = logsumexp(np.multiply.outer(m, logs), axis=-1)
            return count * log_modulus + m * logs[broken].sum() - count * spread

        centre = np.log(modulus)
        peak = profile(centre)

        def excess(log_modulus):
            return peak - profile(log_modulus) - allowed

        low = crossing(excess, centre, -0.1)
        high = crossing(excess, centre, 0.1)
        # cosine spacing: the boundary turns steeply at both ends
        angle = np.linspace(0.0, np.pi, POINTS)
        log_moduli = 0.5 * (low + high) + 0.5 * (high - low) * np.cos(angle)
        moduli = np.exp(log_moduli)
        best = (logsumexp(np.multiply.outer(moduli, logs), axis=-1) - np.log(count)) / moduli
        # along u the loss is count * (v + exp(-v) - 1) with v = m (u - best)
        # not 1 itself: -exp(-1), rounded, lies beyond the real branches, and newer versions of scipy give nan
        left = 1.0 + np.maximum(-excess(log_moduli) / count, np.finfo(float).eps)
        shifts = [left + lambertw(-np.exp(-left), branch).real for branch in (0, -1)]
        self.moduli = np.tile(moduli, 2)
        self.locations = np.concatenate([best + shift / moduli for shift in shifts])

    def modulus_interval(self) -> tuple[float, float]:
        """Interval (low, high) of the modulus."""
        return float(self.moduli.min()), float(self.moduli.max())

    def quantile_interval(self, reduced: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Intervals (low, high) of u + reduced / m; reduced (k,)."""
        values = self.locations + np.divide.outer(reduced, self.moduli)
        return values.min(axis=-1), values.max(axis=-1)


def crossing(excess: Callable[[float], float], start: float, step: float) -> float:
    """The x beyond ``start``, on the side of ``step``, where a rising excess(x) becomes zero."""
    far = start + step
    while excess(far) < 0.0:
        step *= 2.0
        far += step
    return brentq(excess, *sorted((start, far)), xtol=1e-13)
