"""[contact]: stiffness and friction where two elements touch."""

from collections.abc import Iterator
from typing import Any, Literal

from grus.card.errors import Problem
from grus.card.interval import NOT_NEGATIVE, POSITIVE, Interval
from grus.card.presence import must_be_absent, must_be_given
from grus.card.pydantic_adapter import Section, key
from grus.card.quantity import Measure, Quantity
from grus.card.values import Choice, Number

KINDS = {"N/m": "total", "Pa": "modulus"}
UNITS = {"N/m": "a total stiffness", "Pa": "a modulus"}
SOLID = ("young_modulus", "poisson_ratio")


class Contact(Section):
    """Contact of two elements with Coulomb friction: linear springs in series, or Hertz-Mindlin; further options."""

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
    law: Literal["linear", "hertz"] = key(
        Choice(("linear", "hertz")),
        "Stiffness of contacts: the two above, or Hertz-Mindlin from young_modulus and poisson_ratio; the two above then "
        "only serve to prepare a specimen.",
        default="linear",
    )
    young_modulus: Measure | None = key(
        Quantity({"Pa": "a modulus"}, POSITIVE, "70 GPa"),
        "Young's modulus of the elements' solid.",
        default=None,
        default_text="needed for law hertz, else left out",
    )
    poisson_ratio: float | None = key(
        Number(Interval(least=0, most=0.5)),
        "Poisson's ratio of the elements' solid.",
        default=None,
        default_text="needed for law hertz, else left out",
    )
    unloading_ratio: float = key(
        Number(Interval(least=1)),
        "Normal stiffness of a contact that is unloaded or reloaded, over that of first loading (Walton & Braun 1986); "
        "1: elastic.",
        default=1,
    )
    rolling_friction: float = key(
        Number(NOT_NEGATIVE),
        "Largest moment that resists rolling, over normal force and radius; 0: no rolling resistance.",
        default=0,
    )
    rolling_stiffness: float = key(
        Number(NOT_NEGATIVE),
        "Stiffness against rolling, over shear stiffness and both radii.",
        default=0,
    )

    @property
    def stiffness_kind(self) -> str:
        """How the stiffnesses are given: 'total' [N/m] or 'modulus' [Pa]."""
        return KINDS[self.normal_stiffness.unit]

    @staticmethod
    def problems(section: Any) -> Iterator[Problem]:
        yield from same_way(section.normal_stiffness, section.shear_stiffness)
        check = must_be_given if section.law == "hertz" else must_be_absent
        yield from check(section, SOLID, f"law {section.law}")
        if section.law == "hertz" and section.unloading_ratio != 1:
            yield Problem("not with law hertz", "1, or law linear", "unloading_ratio")
        rolling = {
            name: getattr(section, name) for name in ("rolling_friction", "rolling_stiffness")
        }
        if 0 in rolling.values() and any(rolling.values()):
            missing = min(rolling, key=rolling.get)
            yield Problem("the other one is not 0", "both 0, or both more", missing)


def same_way(normal: Measure, shear: Measure) -> Iterator[Problem]:
    """Refuses a shear stiffness in another unit than the normal one."""
    if normal.unit != shear.unit:
        reason = f"not given in the same way as normal_stiffness [{normal.unit}]"
        yield Problem(reason, f"a stiffness in {normal.unit}", "shear_stiffness")
