"""Maximum likelihood of the two-parameter Weibull law, in logarithms.

With y = ln(strength), modulus m and location u = ln(sigma_0) the survival probability is
exp(-exp(m (y - u))). For a given m the best location is known in closed form, and the modulus is
the only root of a function that rises steadily (Thoman, Bain & Antle 1969, Technometrics 11:445).
"""

from __future__ import annotations

import numpy as np
from scipy.optimize import brentq
from scipy.special import logsumexp

ROOT_TOLERANCE = 8.9e-16  # brentq refuses less than 4 eps


def maximum_likelihood(logs: np.ndarray, broken: np.ndarray) -> tuple[float, float]:
    """Modulus and location of one sample; logs (n,), broken (n,) bool (False = right-censored).

    The sample must have scatter (see ``strength_sample``). Bracketing and Brent's method, so that
    it cannot fail for any n, scale or spread.
    """
    top = logs.max()
    spread = top - logs[broken].mean()
    scaled = (logs - top) / spread

    def slope(modulus: float) -> float:
        weights = np.exp(modulus * scaled)
        return weights @ scaled / weights.sum() - 1.0 / modulus + 1.0

    upper = 2.0
    while slope(upper) < 0.0:
        upper *= 2.0
    # the weighted mean of `scaled` is never positive, so the slope is not positive at 1
    modulus = brentq(slope, 1.0, upper, xtol=1e-300, rtol=ROOT_TOLERANCE) / spread
    return modulus, best_location(logs, broken, modulus)


def best_location(logs: np.ndarray, broken: np.ndarray, modulus: float) -> float:
    """Location that maximises the likelihood for a given modulus."""
    return (logsumexp(modulus * logs) - np.log(broken.sum())) / modulus


def log_likelihood(logs: np.ndarray, broken: np.ndarray, modulus: float, location: float) -> float:
    """Log-likelihood in terms of the density of ``logs``."""
    reduced = modulus * (logs - location)
    return float(broken.sum() * np.log(modulus) + reduced[broken].sum() - np.exp(reduced).sum())


def maximum_likelihood_rows(logs: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Moduli (N,) and locations (N,) of N complete samples at once; logs (N, n).

    Newton's method on ln(modulus), from the moments, each step limited to a factor e.
    """
    top = logs.max(axis=1, keepdims=True)
    scaled = logs - top
    mean = scaled.mean(axis=1)
    modulus = np.pi / np.sqrt(6.0) / scaled.std(axis=1)
    step = np.ones_like(modulus)
    while np.abs(step).max() > 1e-9:  # quadratic: the error left is far below rounding
        weights = np.exp(modulus[:, None] * scaled)
        total = weights.sum(axis=1)
        weights *= scaled
        first = weights.sum(axis=1) / total
        second = np.einsum("ij,ij->i", weights, scaled) / total
        slope = first - 1.0 / modulus - mean
        curvature = second - first**2 + 1.0 / modulus**2
        step = np.clip(-slope / (modulus * curvature), -1.0, 1.0)
        modulus = modulus * np.exp(step)
    weights = np.exp(modulus[:, None] * scaled)
    return modulus, np.log(weights.mean(axis=1)) / modulus + top[:, 0]
