"""The verdict: nothing left out, a mechanism named, cannot tell, or something unknown."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

from grus.diagnosis.evidence import Explanation, inclusion

Kind = Literal["nothing", "named", "cannot_tell", "unknown"]

NAMED = 0.75
"""Probability from which a mechanism is named."""
DECIDED = 0.5
"""Probability from which nothing, or something unknown, is the verdict."""
WHITE = 0.001
"""Probability that the rest is white, below which something else is at work."""
REPRODUCED = 5.0
"""Factor between the effect in the runs and the one that the recording asks for, up to which a mechanism is reproduced."""
POSSIBLE = 0.1
"""Probability from which a mechanism is one of those that cannot be told apart."""


@dataclass(frozen=True)
class Decision:
    """kind: of verdict. named: mechanisms it names, or cannot tell apart, most probable first. probability: of each suspect,
    "unknown" and "nothing" among them."""

    kind: Kind
    named: tuple[str, ...]
    probability: dict[str, float]


def decide(found: Sequence[Explanation], complete: bool = True, whiteness: float = 1.0) -> Decision:
    """From the probabilities of all sets of suspects.

    complete: whether all known mechanisms were among them, without which nothing can be called unknown. whiteness:
    probability that what the best known mechanisms leave is without order; where it is not, they do not explain it.
    """
    probability = inclusion(found)
    nothing = sum(e.probability for e in found if not e.names)
    unknown = probability.setdefault("unknown", 0.0)
    probability["nothing"] = nothing
    mechanisms = sorted(
        (name for name in probability if name not in ("unknown", "nothing")),
        key=lambda name: -probability[name],
    )
    named = tuple(name for name in mechanisms if probability[name] >= NAMED)
    if unknown >= DECIDED or whiteness < WHITE:
        return Decision("unknown" if complete else "cannot_tell", (), probability)
    if named:
        return Decision("named", named, probability)
    if nothing >= DECIDED:
        return Decision("nothing", (), probability)
    possible = tuple(name for name in mechanisms if probability[name] >= POSSIBLE)
    return Decision("cannot_tell", possible, probability)


def confirmed(decision: Decision, reproduced: float | None, between: bool = False) -> Decision:
    """A verdict that names mechanisms, after the runs with these: without any, or with another effect, it is a curve fit, which
    cannot tell.

    reproduced: effect in the runs over the one that the recording asks for; None when no run came to an end. between: whether that
    one lies between the effects of runs of nearly the same size.
    """
    if reproduced is not None and (between or 1 / REPRODUCED <= reproduced <= REPRODUCED):
        return decision
    return replace(decision, kind="cannot_tell")
