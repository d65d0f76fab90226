"""Whether what is left after the best explanation is without order."""

from dataclasses import dataclass

import numpy as np
from scipy import stats
from scipy.linalg import cholesky, solve_triangular


@dataclass(frozen=True)
class Whiteness:
    """Probabilities that white residuals look as much out of order as these, or more: sum of squares (chi-square),
    runs of like signs (Wald & Wolfowitz 1940), correlation of neighbours (Ljung & Box 1978). residuals (n,): whitened.
    """

    chi_squared: float
    runs: float
    neighbours: float
    residuals: np.ndarray

    @property
    def smallest(self) -> float:
        """Of the three, times three for their number, at most 1."""
        return min(3 * min(self.chi_squared, self.runs, self.neighbours), 1.0)


def whiteness(rest: np.ndarray, covariance: np.ndarray) -> Whiteness:
    """Of a residual (n,) with its covariance (n, n), in the order of the test."""
    white = solve_triangular(cholesky(covariance, lower=True), rest, lower=True)
    return Whiteness(
        float(stats.chi2.sf(white @ white, len(white))), _runs(white), _ljung_box(white), white
    )


def _runs(white: np.ndarray) -> float:
    signs = white > 0
    up, n = int(signs.sum()), len(signs)
    down = n - up
    if up < 2 or down < 2:
        return 1.0
    runs = 1 + int((signs[1:] != signs[:-1]).sum())
    expected = 1 + 2 * up * down / n
    variance = (expected - 1) * (expected - 2) / (n - 1)
    # Few runs are order; many are noise that was counted as smooth.
    return float(stats.norm.cdf((runs - expected) / np.sqrt(max(variance, 1e-12))))


def _ljung_box(white: np.ndarray, lags: int = 3) -> float:
    n = len(white)
    if n <= lags + 2:
        return 1.0
    centred = white - white.mean()
    # What is smaller than its noise has no order that could mean anything: correlations are over a variance of 1 at least.
    power = max(float(centred @ centred), float(n))
    r = np.array([centred[k:] @ centred[: n - k] / power for k in range(1, lags + 1)])
    # As with the runs: neighbours that are alike are order, neighbours that differ are noise that was taken for less.
    r = np.maximum(r, 0.0)
    return float(stats.chi2.sf(n * (n + 2) * np.sum(r**2 / (n - np.arange(1, lags + 1))), lags))
