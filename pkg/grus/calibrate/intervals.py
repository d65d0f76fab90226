"""How well the targets fix the parameters, told by the trials around the best one."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.stats import norm

from grus.calibrate.local import local
from grus.calibrate.targets import Targets
from grus.calibrate.trial import Trial

CONFIDENCE = 0.95
UNIFORM = 1 / 12
"""Variance of a share of which nothing is known but its bounds."""
KNOWN = 0.5
"""Standard deviation, as a share of that, below which a parameter counts as fixed by the targets."""


@dataclass(frozen=True)
class Intervals:
    """What is known of the parameters.

    low, high: shares (p,) within which each lies at CONFIDENCE. fixed: whether the targets fix it better than its bounds
    do (p,). correlation: of the parameters (p, p).
    """

    low: tuple[float, ...]
    high: tuple[float, ...]
    fixed: tuple[bool, ...]
    correlation: tuple[tuple[float, ...], ...]


def intervals(targets: Targets, trials: Sequence[Trial]) -> Intervals | None:
    """Intervals about the best trial; None when too few trials show all that it shows.

    The variance of a target is that of its tolerance and of the model's own scatter; the values of a curve share its
    weight. Parameters have a Gaussian prior as wide as their bounds.
    """
    around = local(targets, trials)
    if around is None:
        return None
    precision = np.eye(len(around.centre)) / UNIFORM
    for target in around.targets:
        variance = len(target.own) * (1 + target.own**2)
        precision += (target.slope / variance) @ target.slope.T
    covariance = np.linalg.inv(precision)
    deviation = np.sqrt(np.diag(covariance))
    half = norm.ppf((1 + CONFIDENCE) / 2) * deviation
    low, high = np.clip([around.centre - half, around.centre + half], 0, 1).tolist()
    return Intervals(
        low=tuple(low),
        high=tuple(high),
        fixed=tuple((deviation < KNOWN * np.sqrt(UNIFORM)).tolist()),
        correlation=tuple(map(tuple, (covariance / np.outer(deviation, deviation)).tolist())),
    )
