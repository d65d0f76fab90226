"""The ordinary parameters of the model: what a calibration may change before any physics is said to be missing."""

from dataclasses import dataclass, replace

from grus.card import Card
from grus.card.quantity import Measure

STIFFNESSES = (
    "contact.normal_stiffness",
    "contact.shear_stiffness",
    "bond.normal_stiffness",
    "bond.shear_stiffness",
)
STRENGTHS = ("bond.tensile_strength", "bond.shear_strength")
STIFFNESS_BOUNDS = (0.02, 50.0)
STEP = 2**0.5
"""Factor between the strengths that are simulated."""
WEAKEST, STRONGEST = -2, 10
"""Bounds of the strength, in such steps from the highest stress of the test."""


@dataclass(frozen=True)
class Base:
    """strength: tensile strength of bonds in steps of a factor of sqrt(2), from the highest axial stress of the test on;
    None for bonds that never break. Steps let tests of the same program share their runs. friction: factor on the
    coefficient. stiffness: factor on the stiffnesses of contacts and bonds; all but the runs of the end have 1, since
    strain in slow, small deformation goes as 1/stiffness.

    The void ratio is that of the card; that of other specimens is part of the scatter between seeds.
    """

    strength: int | None
    friction: float = 1.0
    stiffness: float = 1.0

    def unbreakable(self) -> "Base":
        """The same with bonds that never break."""
        return replace(self, strength=None)

    def strength_factor(self, card: Card, highest: float) -> float:
        """On the strengths of the card; highest: axial stress of the test [Pa]."""
        steps = 40 if self.strength is None else self.strength
        return highest * STEP**steps / float(card.bond.tensile_strength)

    def apply(self, card: Card, highest: float) -> Card:
        """The card with these parameters; highest: axial stress of the test [Pa]."""
        friction = card.contact.friction_coefficient * self.friction
        changes: dict[str, object] = {"contact.friction_coefficient": round(friction, 6)}
        changes.update(_scaled(card, STIFFNESSES, self.stiffness))
        changes.update(_scaled(card, STRENGTHS, self.strength_factor(card, highest)))
        return card.with_overrides(changes)


def _scaled(card: Card, keys: tuple[str, ...], factor: float) -> dict[str, str]:
    result = {}
    for key in keys:
        table, name = key.split(".")
        value = getattr(getattr(card, table), name)
        if value is not None:
            result[key] = Measure(float(f"{value * factor:.6g}"), value.unit).written()
    return result
