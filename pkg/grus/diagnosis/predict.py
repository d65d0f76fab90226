"""What a model that has seen some stages of a recording says of the others."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.special import logsumexp

from grus.diagnosis.evidence import log_density
from grus.diagnosis.layout import Layout
from grus.diagnosis.locate import chi_squared

Effects = Sequence[tuple[np.ndarray, np.ndarray]]
"""Change (n,) and its covariance (n, n) at each size that is possible."""


@dataclass(frozen=True)
class Error:
    """rmse_strain: root mean square error of strain within stages, each counted from its own beginning [-]. chi2_dof:
    chi-square over the numbers compared. rmse_base: root mean square error of the stress at the base over that at the
    top, as a share of it [-]; None where it was not recorded."""

    rmse_strain: float
    chi2_dof: float
    rmse_base: float | None = None


def predicted(
    difference: np.ndarray,
    covariance: np.ndarray,
    noise: np.ndarray,
    effects: Effects,
    seen: np.ndarray,
) -> tuple[np.ndarray, np.ndarray]:
    """Middle (n,) and covariance (n, n) of a recording less its base, freed of noise, after the numbers `seen` (n,) of it.

    The numbers that were seen adjust the calibration, the specimen, and the size of the effect; with nothing seen
    each size counts alike. Conditional mean of a normal law; of the sizes,
    the median counts.
    """
    logs, means, spreads = [], [], []
    a = np.flatnonzero(seen)
    for change, more in effects:
        signal = covariance + more
        rest = difference[a] - change[a]
        if not len(a):
            logs.append(0.0)
            means.append(change)
            spreads.append(signal)
            continue
        whole = signal[np.ix_(a, a)] + noise[np.ix_(a, a)]
        gain = np.linalg.solve(whole, signal[a]).T
        logs.append(log_density(rest, whole))
        means.append(change + gain @ rest)
        spreads.append(signal - gain @ signal[a])
    weights = np.exp(np.array(logs) - logsumexp(logs))
    mean = _median(np.array(means), weights)
    inside = np.einsum("i,ijk->jk", weights, np.array(spreads))
    between = np.array(means) - mean
    return mean, inside + np.einsum("i,ij,ik->jk", weights, between, between)


def _median(values: np.ndarray, weights: np.ndarray) -> np.ndarray:
    """Weighted median (n,) of values (m, n): a few large sizes that cannot be excluded do not carry it away."""
    order = np.argsort(values, axis=0)
    shares = np.cumsum(weights[order], axis=0)
    first = (shares >= 0.5 * shares[-1]).argmax(axis=0)
    return np.take_along_axis(values, order, axis=0)[first, np.arange(values.shape[1])]


def error(
    compared: Layout,
    difference: np.ndarray,
    mean: np.ndarray,
    covariance: np.ndarray,
    which: np.ndarray,
) -> Error:
    """Of a prediction, over the numbers `which` (n,)."""
    rest = difference - mean
    squares, count = 0.0, 0
    for stage in {e.stage for e in compared.entries}:
        own = which & compared.where(stage=stage, channel="strain")
        if own.any():
            # Strain since the beginning of the stage, at each knot.
            squares += float((np.cumsum(rest[own]) ** 2).sum())
            count += int(own.sum())
    whole = (covariance + compared.noise)[np.ix_(which, which)]
    base = rest[which & compared.where(channel="base")]
    return Error(
        float(np.sqrt(squares / max(count, 1))),
        chi_squared(rest[which], whole) / max(int(which.sum()), 1),
        float(np.sqrt(np.mean(base**2))) if len(base) else None,
    )
