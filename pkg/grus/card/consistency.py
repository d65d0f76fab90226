"""What the tables of a card ask of each other."""

from collections.abc import Iterator
from math import inf, log10
from typing import Any

from grus.card.agglomerate import OUTLINES
from grus.card.contact_consistency import contact_inconsistencies
from grus.card.errors import Problem
from grus.card.specimen_consistency import specimen_inconsistencies
from grus.card.time_consistency import time_inconsistencies

MOST_ELEMENTS = 1e6  # of one grain


def inconsistencies(card: Any) -> Iterator[Problem]:
    """Problems between tables that are good one by one."""
    outlines = OUTLINES[card.dimension]
    if card.agglomerate.outline not in outlines:
        allowed = " or ".join(f'"{outline}"' for outline in outlines)
        yield Problem(f"not with dimension {card.dimension}", allowed, "agglomerate.outline")
    if card.dimension == 3 and card.thickness is not None:
        yield Problem("dimension 3 has no use for it", "leave the key out", "thickness")
    yield from _size(card.dimension, card.element.radius, card.agglomerate.diameter)
    yield from contact_inconsistencies(card)
    yield from specimen_inconsistencies(card)
    yield from time_inconsistencies(card)


def _size(dimension: int, radius: float, diameter: float) -> Iterator[Problem]:
    across = diameter / radius / 2 if diameter / radius < inf else 1e300
    if across < 2:
        reason = f"only {across:.3g} elements across"
        yield Problem(reason, "at least 4 times element.radius", "agglomerate.diameter")
    elif dimension * log10(across) > log10(MOST_ELEMENTS):
        reason = f"about 1e{dimension * log10(across):.0f} elements in a grain"
        yield Problem(reason, f"at most {MOST_ELEMENTS:.0f} elements", "element.radius")
