"""Which suspects explain a misfit: marginal likelihoods of all small sets of them.

For each set the sizes of its members are integrated over their grids; calibration and scatter are in the covariance. A
set earns its place by the likelihood of the recording under it, averaged over all that it allows: one that could explain
anything explains little (Occam's factor).
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
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
LIKELIEST, BETWEEN = 4, 4
"""Sizes of each member in sets of two or three: the likeliest, and some between."""
PASSES = 2
"""Times that the likeliest size of each member is sought beside those of the others."""


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
    table = {s.name: [(*s.effect(size), s.levels(size)) for size in s.grid] for s in suspects}
    grids = {s.name: s.grid for s in suspects}

    def log_likelihood(names: tuple[str, ...], places: tuple[int, ...]) -> float:
        mean, spread = np.zeros_like(misfit), covariance.copy()
        levels = [np.zeros((len(misfit), 0))]
        for name, place in zip(names, places):
            change, more, level = table[name][place]
            mean, spread = mean + change, spread + more
            levels.append(level)
        return temper * _log(misfit - mean, spread, np.hstack(levels))

    def explain(names: tuple[str, ...], start: Sequence[int] = ()) -> Explanation:
        chosen = [np.arange(len(grids[n])) for n in names]
        if len(names) > 1:
            log = partial(log_likelihood, names)
            chosen = _telling(log, [len(grids[n]) for n in names], list(start))
        shares = [_shares(c, len(grids[n])) for c, n in zip(chosen, names)]
        found = [
            (
                places,
                log_likelihood(names, places),
                sum(np.log(s[p]) for s, p in zip(shares, places)),
            )
            for places in product(*chosen)
        ]
        logs = np.array([log + prior for _, log, prior in found])
        weights = np.exp(logs - logsumexp(logs))
        return Explanation(
            names,
            float(logsumexp(logs)),
            tuple(
                (tuple(float(grids[n][p]) for n, p in zip(names, places)), float(w))
                for (places, _, _), w in zip(found, weights)
            ),
        )

    names = [s.name for s in suspects]
    alone = [explain((name,)) for name in names]
    start = {e.names[0]: int(np.argmin(np.abs(grids[e.names[0]] - e.best()[0]))) for e in alone}
    result = [explain(()), *alone]
    result += [explain(pair, [start[n] for n in pair]) for pair in _sets(names, 2)]
    likely = _likely(_weighed(result, names), names)
    result += [explain(three, [start[n] for n in three]) for three in _sets(likely, MOST)]
    return sorted(_weighed(result, names), key=lambda e: -e.probability)


def _sets(names: Sequence[str], members: int) -> list[tuple[str, ...]]:
    """All sets but those of an effect with its opposite."""
    every = combinations(names, members)
    return [one for one in every if len({n.replace(":-", ":") for n in one}) == members]


def log_density(x: np.ndarray, covariance: np.ndarray) -> float:
    """Logarithm of the normal density of `x` (n,) with mean 0."""
    return _log(x, covariance, np.zeros((len(x), 0)))


def _log(x: np.ndarray, covariance: np.ndarray, moves: np.ndarray) -> float:
    """Logarithm of the normal density of `x` (n,) with mean 0, times the probability that no level is negative after it was seen.

    moves (n, m): change by a standard deviation of each level, which is 1 plus LEVEL times a normal variable; each counts
    by itself.
    """
    factor = cho_factor(covariance, lower=True, check_finite=False)
    solved = cho_solve(factor, np.column_stack([x, moves]), check_finite=False)
    density = (
        -0.5 * x @ solved[:, 0]
        - np.log(np.diag(factor[0])).sum()
        - 0.5 * len(x) * np.log(2 * np.pi)
    )
    mean = moves.T @ solved[:, 0]
    left = 1 - np.einsum("ij,ij->j", moves, solved[:, 1:])
    signs = log_ndtr((1 + LEVEL * mean) / (LEVEL * np.sqrt(np.maximum(left, 1e-9))))
    return float(density + signs.sum())


def _telling(
    log: Callable[[tuple[int, ...]], float], lengths: Sequence[int], now: list[int]
) -> list[np.ndarray]:
    """Places of each member's grid that count in a set: the likeliest beside the best of the others, and some between."""
    chosen = [np.arange(n) for n in lengths]
    for member in [*range(len(now))] * PASSES:
        logs = [log((*now[:member], k, *now[member + 1 :])) for k in range(lengths[member])]
        order = np.argsort(logs)[::-1]
        now[member] = int(order[0])
        rest = np.sort(order[LIKELIEST:])
        some = rest[np.unique(np.linspace(0, len(rest) - 1, BETWEEN).round().astype(int))]
        chosen[member] = np.array([*order[:LIKELIEST], *(some if len(rest) else ())])
    return chosen


def _shares(chosen: np.ndarray, length: int) -> dict[int, float]:
    """Prior of each place that was chosen: its own, and for those between that of all that were left out."""
    if len(chosen) == length:
        return {int(k): 1 / length for k in chosen}
    between = (length - LIKELIEST) / (len(chosen) - LIKELIEST) / length
    return {int(k): 1 / length if place < LIKELIEST else between for place, k in enumerate(chosen)}


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
