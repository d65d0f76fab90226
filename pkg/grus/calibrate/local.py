"""The targets as linear functions of the parameters around the best trial."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import lsq_linear

from grus.calibrate.misfit import off
from grus.calibrate.targets import Targets
from grus.calibrate.trial import Trial

NEAR = 2
"""Trials a coefficient within the width of the kernel, where there are so many."""
LEAST = 0.1
"""Least width of the kernel, in shares: trials closer to each other say nothing of a slope."""
SPARE = 2
"""Trials more than coefficients without which there is no regression."""
DIGITS = 6
"""Of a share that is proposed, so that rounding of the regression does not lead to another path."""


@dataclass(frozen=True)
class Linear:
    """One target, in tolerances.

    level (k,): model less target at the best trial. slope (p, k): of it over the shares. own (k,): standard error of the
    model, 0 where it cannot be told.
    """

    level: np.ndarray
    slope: np.ndarray
    own: np.ndarray


@dataclass(frozen=True)
class Local:
    """centre: shares (p,) of the best trial. width: of the kernel. targets: those that the best trial shows."""

    centre: np.ndarray
    width: float
    targets: tuple[Linear, ...]

    def minimum(self) -> tuple[float, ...]:
        """Shares (p,) of the smallest misfit within the bounds and a width of the best trial."""
        rows = [t.slope.T / np.sqrt(len(t.level)) for t in self.targets]
        wanted = [-t.level / np.sqrt(len(t.level)) for t in self.targets]
        low = np.maximum(-self.width, -self.centre - 1e-9)
        high = np.minimum(self.width, 1 - self.centre + 1e-9)
        step = lsq_linear(np.concatenate(rows), np.concatenate(wanted), (low, high)).x
        return tuple(np.clip(np.round(self.centre + step, DIGITS), 0, 1).tolist())


def local(targets: Targets, trials: Sequence[Trial]) -> Local | None:
    """By regression on the trials that show what the best shows, with a Gaussian kernel; None when they are too few."""
    best = min(trials, key=lambda trial: trial.misfit)
    shown = [t for t in targets.targets if best.answers[t.name].missing is None]
    used = [one for one in trials if all(one.answers[t.name].missing is None for t in shown)]
    coefficients = 1 + len(best.shares)
    if len(used) < coefficients + SPARE or not shown:
        return None
    shares = np.array([one.shares for one in used]) - best.shares
    distance = np.sqrt((shares**2).sum(axis=1))
    width = max(float(np.sort(distance)[min(NEAR * coefficients, len(used)) - 1]), LEAST)
    root = np.exp(-0.25 * (distance / width) ** 2)[:, None]  # of the weights
    basis = root * np.column_stack([np.ones(len(used)), shares])
    found = []
    for target in shown:
        values = np.array([off(target, one.answers[target.name]) for one in used])
        level, *slope = np.linalg.lstsq(basis, root * values, rcond=None)[0]
        own = np.nan_to_num(best.answers[target.name].error) / target.tolerance
        found.append(Linear(level, np.array(slope), own))
    return Local(np.array(best.shares), width, tuple(found))
