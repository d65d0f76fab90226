"""[bond]: the cement between the clumps of a grain (Potyondy & Cundall 2004, Potyondy 2011)."""

from collections.abc import Iterator
from math import pi
from typing import Any, Literal

from grus.card.contact import same_way
from grus.card.errors import Problem
from grus.card.interval import POSITIVE, Interval
from grus.card.presence import must_be_absent, must_be_given
from grus.card.pydantic_adapter import Section, key
from grus.card.quantity import Measure, Quantity
from grus.card.scatter import GrainScatter, Scatter
from grus.card.table import Table
from grus.card.values import Choice, Number

STIFFNESS_KINDS = {"N/m": "total", "Pa/m": "area", "Pa": "modulus"}
STIFFNESS_UNITS = {"N/m": "a total stiffness", "Pa/m": "a stiffness per area", "Pa": "a modulus"}
STRENGTH_UNITS = {"Pa": "a stress", "N": "a force"}
STRENGTH_UNIT = {"parallel": "Pa", "contact": "N"}

STIFFNESSES = ("normal_stiffness", "shear_stiffness")
STRENGTHS = ("tensile_strength", "shear_strength")
SECTION = ("radius_ratio", "moment_contribution")


class Bond(Section):
    """Parallel bond (a cemented section), contact bond (two springs at a point), or none."""

    kind: Literal["parallel", "contact", "none"] = key(
        Choice(("parallel", "contact", "none")), "Kind of bond."
    )
    normal_stiffness: Measure | None = key(
        Quantity(STIFFNESS_UNITS, POSITIVE, "3e9 N/m"),
        "Normal stiffness of a parallel bond: of the section, per area, or a modulus E, which is "
        "E/(RA + RB) per area.",
        default=None,
        default_text="needed for parallel bonds, else left out",
    )
    shear_stiffness: Measure | None = key(
        Quantity(STIFFNESS_UNITS, POSITIVE, "3e9 N/m"),
        "Shear stiffness of a parallel bond, given in the same way.",
        default=None,
        default_text="needed for parallel bonds, else left out",
    )
    radius_ratio: float | None = key(
        Number(Interval(above=0, most=1)),
        "Radius of a parallel bond over the smaller element radius (lambda).",
        default=None,
        default_text="1 for parallel bonds, else left out",
    )
    moment_contribution: float | None = key(
        Number(Interval(least=0, most=1)),
        "Weight of the moments in the stress of a parallel bond (beta, Potyondy 2011).",
        default=None,
        default_text="1 for parallel bonds, else left out",
    )
    tensile_strength: Measure | None = key(
        Quantity(STRENGTH_UNITS, POSITIVE, "1 MPa"),
        "Tensile strength: a stress for parallel bonds, a force for contact bonds.",
        default=None,
        default_text="needed for bonds",
    )
    shear_strength: Measure | None = key(
        Quantity(STRENGTH_UNITS, POSITIVE, "1 MPa"),
        "Shear strength, in the same unit; the cohesion when friction_angle is not 0.",
        default=None,
        default_text="needed for bonds",
    )
    friction_angle: Measure = key(
        Quantity(
            {"rad": "an angle"}, Interval(least=0, below=pi / 2), "30 deg", "from 0 to below 90 deg"
        ),
        "Friction angle of the Mohr-Coulomb shear strength; 0: constant shear strength.",
        default="0 deg",
    )
    scatter: Scatter = key(
        Table(Scatter),
        "Scatter of strength from bond to bond.",
        default=Scatter(),
        default_text="none",
    )
    grain_scatter: GrainScatter | None = key(
        Table(GrainScatter),
        "Scatter of strength from grain to grain.",
        default=None,
        default_text="none",
    )

    @property
    def stiffness_kind(self) -> str | None:
        """How stiffness is given: 'total' [N/m], 'area' [Pa/m] or 'modulus' [Pa]; None without."""
        normal = self.normal_stiffness
        return None if normal is None else STIFFNESS_KINDS[normal.unit]

    @staticmethod
    def problems(section: Any) -> Iterator[Problem]:
        what = {"none": "kind none"}.get(section.kind, f"a {section.kind} bond")
        if section.kind == "parallel":
            yield from must_be_given(section, STIFFNESSES, what)
            if section.normal_stiffness is not None and section.shear_stiffness is not None:
                yield from same_way(section.normal_stiffness, section.shear_stiffness)
        else:
            yield from must_be_absent(section, STIFFNESSES + SECTION, what)
        if section.kind == "none":
            yield from must_be_absent(section, (*STRENGTHS, "grain_scatter"), what)
            yield from _no_strength_to_change(section)
        else:
            yield from must_be_given(section, STRENGTHS, what)
            yield from _unit_of_strength(section, what)


def _unit_of_strength(section: Any, what: str) -> Iterator[Problem]:
    unit = STRENGTH_UNIT[section.kind]
    for name in STRENGTHS:
        strength = getattr(section, name)
        if strength is not None and strength.unit != unit:
            reason = f"{what} needs {STRENGTH_UNITS[unit]}, this is {STRENGTH_UNITS[strength.unit]}"
            yield Problem(reason, f"{STRENGTH_UNITS[unit]} [{unit}] > 0", name)


def _no_strength_to_change(section: Any) -> Iterator[Problem]:
    if section.scatter.kind != "none":
        yield Problem("kind none has no use for it", '"none"', "scatter.kind")
    if section.friction_angle != 0:
        yield Problem("kind none has no use for it", "leave the key out", "friction_angle")
