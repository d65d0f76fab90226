"""What [specimen] and [preparation] ask of the other tables."""

from collections.abc import Iterator
from typing import Any

from grus.card.bond import STRENGTH_UNIT, STRENGTH_UNITS
from grus.card.errors import Problem


def specimen_inconsistencies(card: Any) -> Iterator[Problem]:
    """Problems between the specimen, its preparation and the rest of the card."""
    if card.specimen is None:
        if card.preparation is not None:
            yield Problem("has no use without [specimen]", "leave the table out", "preparation")
        return
    if card.dimension == 2 and card.specimen.depth is not None:
        yield Problem("dimension 2 has no use for it", "leave the key out", "specimen.depth")
    if card.dimension == 3 and card.specimen.depth is None:
        yield Problem("is missing, dimension 3 needs it", key="specimen.depth")
    yield from _grain_sizes(card.specimen, card.element.radius)
    yield from _bond_strength(card.preparation, card.bond.kind)


def _grain_sizes(specimen: Any, radius: float) -> Iterator[Problem]:
    table = specimen.sieve is not None
    smallest = specimen.sieve[0] if table else specimen.minimum_diameter
    largest = specimen.sieve[-1] if table else specimen.maximum_diameter
    if smallest < 4 * radius:
        reason = f"a grain {smallest / radius / 2:.3g} elements across"
        key = "specimen.sieve" if table else "specimen.minimum_diameter"
        yield Problem(reason, f"at least 4 times element.radius, {4 * radius:g} m", key)
    for name in ("width", "height", "depth"):
        size = getattr(specimen, name)
        if size is not None and size < 2 * largest:
            reason = "less than two of the largest grains"
            yield Problem(reason, f"at least {2 * largest:g} m", f"specimen.{name}")


def _bond_strength(preparation: Any, kind: str) -> Iterator[Problem]:
    strength = preparation.bond_strength
    if strength is None:
        return
    if kind == "none":
        reason, allowed = "bond.kind none has no use for it", "leave the key out"
        yield Problem(reason, allowed, "preparation.bond_strength")
    elif strength.unit != STRENGTH_UNIT[kind]:
        unit = STRENGTH_UNIT[kind]
        reason = f"a {kind} bond needs {STRENGTH_UNITS[unit]}"
        yield Problem(reason, f"{STRENGTH_UNITS[unit]} [{unit}] > 0", "preparation.bond_strength")
