"""Which runs a diagnosis makes, in the order of their use."""

from dataclasses import dataclass

from grus.card import Card
from grus.diagnosis.protocol import Protocol
from grus.errors import GrusError
from grus.mechanisms import MECHANISMS, Mechanism, Parameter

SEEDS = 5
"""Specimens of the base, whose scatter counts."""
PAIRED = 3
"""Specimens of a fingerprint for which bonds may break. Those of the others are all of SEEDS: one specimen in three or four
rearranges at another stress when a force changes a little, and their runs serve every recording of the same program."""
WHOLE = ("wall_friction", "hertzian_contact", "contact_plasticity", "rolling_resistance")
"""Mechanisms whose fingerprint is taken where no bond breaks: whatever changes a force a little sets off other avalanches,
and of what that changes nothing is the mechanism's own. Such runs serve bonds of any strength."""
FRICTION = 1.25
"""Factor on friction at which its fingerprint is taken."""
INSTRUMENT = ("platen_compliance", "instrument_drift")
"""Mechanisms that only change what is written down of a test."""


@dataclass(frozen=True)
class Direction:
    """One parameter of a mechanism that is changed from no effect to the sizes given, weak to strong.

    signs: of the effects that are looked for. free: whether no run is needed, since the effect is one of the instrument.
    """

    mechanism: Mechanism
    parameter: Parameter
    sizes: tuple[float, ...]
    signs: tuple[int, ...] = (1,)
    free: bool = False

    def values(self, size: float) -> tuple[tuple[str, float], ...]:
        """Of the mechanism's parameters at a size."""
        return ((self.parameter.name, size),)


def directions(program: Protocol, card: Card) -> tuple[list[Direction], dict[str, str]]:
    """All that can be looked for in a recording, and the mechanisms that this card cannot be given, with the reason."""
    result, unfit = [], {}
    for mechanism in MECHANISMS.values():
        if not shows(mechanism, program):
            continue
        try:
            mechanism.apply(card, {})
        except GrusError as error:
            unfit[mechanism.name] = str(error)
            continue
        free = mechanism.name in INSTRUMENT
        for parameter in mechanism.parameters if free else mechanism.parameters[:1]:
            sizes = tuple(size for size in parameter.sizes if size != parameter.off)
            # A parameter without an off value only shapes the effect of another.
            if not sizes or (free and parameter.off is None):
                continue
            # What needs no run takes all sizes; the strongest may crush all that there is.
            kept = sizes if free else sizes[:2]
            signs = (1, -1) if parameter.low < 0 < parameter.high else (1,)
            result.append(Direction(mechanism, parameter, kept, signs, free))
    return result, unfit


def shows(mechanism: Mechanism, program: Protocol) -> bool:
    """Whether a test of this kind could show the mechanism at all."""
    if mechanism.name == "instrument_drift":
        return program.timed
    if mechanism.name == "wetting_collapse":
        return program.jump is not None
    return True
