"""What a mechanism changes in a simulated test of the recording's protocol.

Each is a difference of paired runs: the same specimen with the mechanism on and off. Paired differences scatter far less
than specimens do.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from grus.diagnosis.layout import Layout
from grus.mechanisms import Mechanism, Parameter

BEYOND = 4.0
"""Effect over that of the largest size run, up to which a fingerprint is scaled."""
LEAST = 0.05
"""Smallest effect that is considered, over that of the smallest size run."""
POINTS = 48
"""Sizes between which a mechanism is looked for."""
ALIKE = 0.5
"""Least sum over the holds of a change, over the sum of its sizes, for which they are taken to share their course with time."""
FEW = {2: 1.196, 3: 1.495, 4: 1.363, 5: 1.206, 6: 1.2, 7: 1.14, 8: 1.129, 9: 1.107}
"""Corrections of the median absolute deviation for small samples (Croux & Rousseeuw 1992, Computational Statistics 1:411-428)."""


@dataclass(frozen=True)
class Fingerprint:
    """mechanism: which. parameter: the one that is changed, the others being as `Mechanism.complete` has them. sign: 1,
    or -1 where an effect may go either way and this is the other.

    sizes: values (g,) of the parameter that were run, weak to strong. changes (g, n): of the vector of a Layout at
    each. errors (g, n): standard errors of these changes, from the seeds.
    """

    mechanism: Mechanism
    parameter: Parameter
    sizes: tuple[float, ...]
    changes: np.ndarray
    errors: np.ndarray
    sign: int = 1

    def grid(self) -> np.ndarray:
        """Effects (m,) that are considered: 1, 2, ... at the sizes run; less than 1 is a share of the weakest."""
        last = len(self.sizes)
        return np.concatenate(
            [np.geomspace(LEAST, 1, POINTS // 2)[:-1], np.linspace(1, last + 1, POINTS // 2 + 1)]
        )

    def at(self, effect: float) -> tuple[np.ndarray, np.ndarray]:
        """Change (n,) and its standard error (n,) at an effect of `grid`; linear between the sizes run."""
        last = len(self.sizes)
        points = np.arange(last + 2)
        scale = np.vstack([0 * self.changes[:1], self.changes, BEYOND * self.changes[-1:]])
        error = np.vstack([0 * self.errors[:1], self.errors, BEYOND * self.errors[-1:]])
        below = min(int(effect), last)
        share = effect - points[below]
        change = (1 - share) * scale[below] + share * scale[below + 1]
        return self.sign * change, (1 - share) * error[below] + share * error[below + 1]

    def value(self, effect: float) -> float:
        """The parameter at an effect, within its bounds."""
        size = self.parameter
        last = len(self.sizes)
        if effect < 1:
            found = _toward_off(size, self.sizes[0], effect)
        elif effect >= last:
            found = _toward_off(size, self.sizes[-1], 1 + (BEYOND - 1) * (effect - last))
        else:
            low, high = self.sizes[int(effect) - 1], self.sizes[int(effect)]
            share = effect - int(effect)
            if size.logarithmic:
                found = low * (high / low) ** share
            else:
                found = low + share * (high - low)
        return min(max(self.sign * found, size.low), size.high)

    def outside(self, effect: float) -> bool:
        """Whether an effect is stronger than any that was run."""
        return effect > len(self.sizes) + 1e-9


def fingerprint(
    mechanism: Mechanism,
    parameter: Parameter,
    sizes: Sequence[float],
    pairs: Sequence[Sequence[tuple[np.ndarray, np.ndarray]]],
    compared: Layout,
    sign: int = 1,
) -> Fingerprint:
    """Of paired vectors (on, off), for each size one pair a seed."""
    changes, errors = [], []
    for of_size in pairs:
        differences = np.array([on - off for on, off in of_size])
        holds = compared.where(kind="hold")
        # Breakage makes first loading heavy-tailed; in holds the mean counts, for creep comes in few large steps.
        mean = np.where(holds, differences.mean(0), np.median(differences, 0))
        changes.append(_smoothed(mean, compared))
        errors.append(np.where(holds, _error_of_mean(differences), _error_of_median(differences)))
    return Fingerprint(
        mechanism, parameter, tuple(sizes), np.array(changes), np.array(errors), sign
    )


def _error_of_mean(differences: np.ndarray) -> np.ndarray:
    """Standard error (n,) of the mean of (seeds, n); that of one seed is as large as itself."""
    if len(differences) == 1:
        return np.abs(differences[0])
    return differences.std(0, ddof=1) / np.sqrt(len(differences))


def _error_of_median(differences: np.ndarray) -> np.ndarray:
    """The same of the median, in which one specimen that rearranged at another stress than the rest counts no more than any."""
    count = len(differences)
    if count == 1:
        return np.abs(differences[0])
    deviation = 1.4826 * np.median(np.abs(differences - np.median(differences, 0)), 0)
    return FEW.get(count, count / (count - 0.8)) * deviation * np.sqrt(np.pi / 2 / count)


def _smoothed(change: np.ndarray, compared: Layout) -> np.ndarray:
    """Shares of the cells of a hold, drawn to their mean over the holds with the same cells.

    A few seeds give a few delayed failures in each hold; what they have in common is the course with time.
    """
    result = change.copy()
    groups: dict[tuple, list[np.ndarray]] = {}
    for stage in {e.stage for e in compared.entries}:
        own = np.flatnonzero(compared.where(stage=stage, kind="hold", channel="strain"))
        if len(own) > 1:
            key = tuple(round(compared.entries[i].end, 3) for i in own)
            groups.setdefault(key, []).append(own)
    for holds in groups.values():
        total = np.sum([change[own] for own in holds], axis=0)
        # Where holds or cells cancel there is no course that they share.
        if abs(total.sum()) <= ALIKE * sum(np.abs(change[own]).sum() for own in holds):
            continue
        shares = total / total.sum()
        for own in holds:
            result[own] = change[own].sum() * shares
    return result


def _toward_off(size: Parameter, strength: float, effect: float) -> float:
    """Value at which the effect is `effect` times that at `strength`, to first order."""
    if size.off is None:
        # No finite value is without effect: it fades as the value grows, or as it falls.
        weakens_upwards = size.sizes[0] >= size.sizes[-1]
        return strength / effect if weakens_upwards else strength * effect
    if size.logarithmic and size.off > 0:
        return size.off * (strength / size.off) ** effect
    return size.off + effect * (strength - size.off)
