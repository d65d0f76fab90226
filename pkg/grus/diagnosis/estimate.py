"""Sizes of the mechanisms that are named."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from grus.diagnosis.evidence import Explanation
from grus.diagnosis.scaling import Scaling
from grus.diagnosis.suspect import Known, Suspect

INTERVAL = (0.05, 0.95)
"""Shares of the probability below the ends of an interval."""


@dataclass(frozen=True)
class Estimate:
    """A parameter of a mechanism, with an interval that holds it with a probability of 90 %; SI unit.

    outside: the value lies beyond those at which fingerprints were run.
    """

    name: str
    value: float
    low: float
    high: float
    unit: str
    outside: bool = False

    def to_dict(self) -> dict[str, Any]:
        return asdict(self)


@dataclass(frozen=True)
class Culprit:
    """A mechanism that has been left out: its probability, and its parameters as far as the recording gives them."""

    name: str
    title: str
    probability: float
    parameters: tuple[Estimate, ...]

    def values(self) -> tuple[tuple[str, float], ...]:
        """Of its parameters, by name."""
        return tuple((one.name, one.value) for one in self.parameters)

    def to_dict(self) -> dict[str, Any]:
        return asdict(self)


def culprits(
    names: Sequence[str],
    probability: dict[str, float],
    found: Sequence[Explanation],
    suspects: Sequence[Suspect],
    scaling: Scaling,
) -> list[Culprit]:
    """Mechanisms by name with their sizes, from all explanations that hold them."""
    known = {s.name: s for s in suspects if isinstance(s, Known)}
    result = []
    for name in names:
        best = next(e for e in found if any(n.split(":")[0] == name for n in e.names))
        estimates = [
            _estimate(known[member], best, place, scaling)
            for place, member in enumerate(best.names)
            if member.split(":")[0] == name
        ]
        title = next(
            s.fingerprint.mechanism.title
            for s in known.values()
            if s.fingerprint.mechanism.name == name
        )
        result.append(Culprit(name, title, probability[name], tuple(estimates)))
    return result


def _estimate(suspect: Known, best: Explanation, place: int, scaling: Scaling) -> Estimate:
    fingerprint = suspect.fingerprint
    weight: dict[float, float] = {}
    for sizes, share in best.sizes:
        weight[sizes[place]] = weight.get(sizes[place], 0.0) + share
    sizes = np.array(sorted(weight))
    shares = np.cumsum([weight[size] for size in sizes])
    middle = float(np.interp(0.5, shares, sizes))
    ends = [float(np.interp(share, shares, sizes)) for share in INTERVAL]
    factor = 1 / scaling.simulated(fingerprint.mechanism.name, fingerprint.parameter.unit)
    found = [*(suspect.value(size) for size in ends), *suspect.bracket(middle)]
    values = sorted(factor * value for value in found)
    return Estimate(
        fingerprint.parameter.name,
        factor * suspect.value(middle),
        values[0],
        values[-1],
        fingerprint.parameter.unit,
        suspect.outside(middle),
    )
