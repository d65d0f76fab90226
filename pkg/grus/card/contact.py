"""[contact]: stiffness and friction where two elements touch."""

from collections.abc import Iterator
from typing import Any

from grus.card.errors import Problem
from grus.card.interval import NOT_NEGATIVE, POSITIVE
from grus.card.pydantic_adapter import Section, key
from grus.card.quantity import Measure, Quantity
from grus.card.values import Number

KINDS = {"N/m": "total", "Pa": "modulus"}
UNITS = {"N/m": "a total stiffness", "Pa": "a modulus"}


class Contact(Section):
    """Linear contact of two elements in series, with Coulomb friction."""

    normal_stiffness: Measure = key(
        Quantity(UNITS, POSITIVE, "3e9 N/m"),
        "Normal stiffness of one element, total or as a modulus; two in series make a contact.",
    )
    shear_stiffness: Measure = key(
        Quantity(UNITS, NOT_NEGATIVE, "3e9 N/m"),
        "Shear stiffness of one element, given in the same way; two in series make a contact.",
    )
    friction_coefficient: float = key(
        Number(NOT_NEGATIVE), "Coulomb friction coefficient of a contact that is not bonded."
    )

    @property
    def stiffness_kind(self) -> str:
        """How the stiffnesses are given: 'total' [N/m] or 'modulus' [Pa]."""
        return KINDS[self.normal_stiffness.unit]

    @staticmethod
    def problems(section: Any) -> Iterator[Problem]:
        yield from same_way(section.normal_stiffness, section.shear_stiffness)


def same_way(normal: Measure, shear: Measure) -> Iterator[Problem]:
    """Refuses a shear stiffness in another unit than the normal one."""
    if normal.unit != shear.unit:
        reason = f"not given in the same way as normal_stiffness [{normal.unit}]"
        yield Problem(reason, f"a stiffness in {normal.unit}", "shear_stiffness")
