"""Anderson-Darling distance between a complete sample and its Weibull law."""

from __future__ import annotations

import numpy as np


def anderson_darling(reduced: np.ndarray) -> np.ndarray:
    """A^2 of samples along the last axis.

    reduced: (..., n) values m (y - u) in rising order, y = ln(strength), u = ln(sigma_0), so that
    the failure probability is F = 1 - exp(-exp(reduced)) and
    A^2 = -n - sum((2 i - 1) (ln F_i + ln(1 - F_(n+1-i)))) / n, i = 1..n.
    """
    n = reduced.shape[-1]
    hazard = np.exp(reduced)
    # -expm1 underflows for very weak grains, where ln F = reduced - hazard/2 to rounding
    log_failure = np.where(
        hazard < 1e-8,
        reduced - 0.5 * hazard,
        np.log(-np.expm1(-np.maximum(hazard, 1e-8))),
    )
    weights = (2.0 * np.arange(1, n + 1) - 1.0) / n
    return -n - (log_failure - hazard[..., ::-1]) @ weights
