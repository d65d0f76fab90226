"""Which suspects explain a misfit: marginal likelihoods of all small sets of them.

For each set the sizes of its members are integrated over their grids; calibration and scatter are in the covariance. A
set earns its place by the likelihood of the recording under it, averaged over all that it allows: one that could explain
anything explains little (Occam's factor).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations, product

import numpy as np
from scipy.linalg import cho_factor, cho_solve
from scipy.special import log_ndtr, logsumexp

from grus.diagnosis.suspect import LEVEL, Suspect

MOST = 3
"""Members of the largest sets."""
KEPT = 6
"""Suspects of which sets of three are made: those most probable in smaller ones."""
PRIOR = (0.4, 0.4, 0.15, 0.05)
"""Probability that 0, 1, 2, 3 suspects are at work, shared evenly by the sets of each size."""
COARSE = 7
"""Sizes of each member in sets of two or three."""


@dataclass(frozen=True)
class Explanation:
    """names: of the set. log_evidence: of the recording under it. sizes: posterior over the product of the grids,
    as (sizes of each member, weight). probability: posterior of the set."""

    names: tuple[str, ...]
    log_evidence: float
    sizes: tuple[tuple[tuple[float, ...], float], ...]
    probability: float = 0.0

    def best(self) -> tuple[float, ...]:
        """Most probable sizes."""
        return max(self.sizes, key=lambda one: one[1])[0]


def explanations(
    misfit: np.ndarray, covariance: np.ndarray, suspects: Sequence[Suspect], temper: float = 1.0
) -> list[Explanation]:
    """All sets, most probable first. misfit (n,): recording less base; covariance (n, n) of it without any suspect.

    temper: power of the likelihood, at most 1; less than 1 where the covariance leaves something out.
    """
    table = {s.name: {size: (*s.effect(size), s.levels(size)) for size in s.grid} for s in suspects}
    grids = {s.name: s.grid for s in suspects}

    def explain(names: tuple[str, ...]) -> Explanation:
        coarse = [_thin(grids[n], COARSE if len(names) > 1 else len(grids[n])) for n in names]
        found = []
        for sizes in product(*coarse):
            mean, spread = np.zeros_like(misfit), covariance.copy()
            levels = []
            for name, size in zip(names, sizes):
                change, more, level = table[name][size]
                mean, spread = mean + change, spread + more
                levels.append(level)
            log = log_density(misfit - mean, spread)
            log += _signs(misfit - mean, spread, levels)
            found.append((sizes, temper * log))
        logs = np.array([log for _, log in found])
        weights = np.exp(logs - logsumexp(logs))
        return Explanation(
            names,
            float(logsumexp(logs) - np.log(len(logs))),
            tuple((sizes, float(w)) for (sizes, _), w in zip(found, weights)),
        )

    names = [s.name for s in suspects]
    result = [explain(())]
    result += [explain((name,)) for name in names]
    result += [explain(pair) for pair in combinations(names, 2)]
    likely = _likely(_weighed(result, names), names)
    result += [explain(three) for three in combinations(likely, MOST)]
    return sorted(_weighed(result, names), key=lambda e: -e.probability)


def log_density(x: np.ndarray, covariance: np.ndarray) -> float:
    """Logarithm of the normal density of `x` (n,) with mean 0."""
    factor = cho_factor(covariance, lower=True, check_finite=False)
    return float(
        -0.5 * x @ cho_solve(factor, x, check_finite=False)
        - np.log(np.diag(factor[0])).sum()
        - 0.5 * len(x) * np.log(2 * np.pi)
    )


def _signs(x: np.ndarray, covariance: np.ndarray, levels: list[np.ndarray]) -> float:
    """Logarithm of the probability that no level (1 + a standard normal variable times LEVEL) is negative, after x (n,)
    was seen; each by itself."""
    if not levels:
        return 0.0
    moves = np.hstack(levels)
    if not moves.shape[1]:
        return 0.0
    factor = cho_factor(covariance, lower=True, check_finite=False)
    solved = cho_solve(factor, np.column_stack([x, moves]), check_finite=False)
    mean = moves.T @ solved[:, 0]
    left = 1 - np.einsum("ij,ij->j", moves, solved[:, 1:])
    return float(log_ndtr((1 + LEVEL * mean) / (LEVEL * np.sqrt(np.maximum(left, 1e-9)))).sum())


def inclusion(found: Sequence[Explanation]) -> dict[str, float]:
    """Probability that each suspect is at work, over all sets, by its name before the colon: of its mechanism."""
    result: dict[str, float] = {}
    for one in found:
        for name in {name.split(":")[0] for name in one.names}:
            result[name] = min(result.get(name, 0.0) + one.probability, 1.0)
    return result


def _weighed(found: list[Explanation], names: Sequence[str]) -> list[Explanation]:
    counts = [1, len(names), len(names) * (len(names) - 1) / 2]
    counts.append(counts[2] * (len(names) - 2) / 3)
    logs = np.array(
        [e.log_evidence + np.log(PRIOR[len(e.names)] / max(counts[len(e.names)], 1)) for e in found]
    )
    shares = np.exp(logs - logsumexp(logs))
    return [Explanation(e.names, e.log_evidence, e.sizes, float(p)) for e, p in zip(found, shares)]


def _likely(found: list[Explanation], names: Sequence[str]) -> list[str]:
    weight = {name: sum(e.probability for e in found if name in e.names) for name in names}
    kept = sorted(names, key=lambda name: -weight[name])[:KEPT]
    return [name for name in names if name in kept]


def _thin(grid: np.ndarray, most: int) -> np.ndarray:
    if len(grid) <= most:
        return grid
    return grid[np.unique(np.linspace(0, len(grid) - 1, most).round().astype(int))]
