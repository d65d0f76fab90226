"""[crush]: crushing of a single grain between two rigid platens."""

from collections.abc import Iterator
from typing import Any, Literal

from grus.card.errors import Problem
from grus.card.interval import NOT_NEGATIVE, POSITIVE, Interval
from grus.card.presence import must_be_absent, must_be_given
from grus.card.pydantic_adapter import Section, key
from grus.card.quantity import Measure, Quantity
from grus.card.values import Choice, Number


class Crush(Section):
    """Test at constant closing speed, or at a constant rate of force with a cap on the speed."""

    control: Literal["speed", "force"] = key(
        Choice(("speed", "force")),
        "What is prescribed: the closing speed, or the force.",
        default="speed",
    )
    speed: Measure = key(
        Quantity({"m/s": "a speed"}, POSITIVE, "0.02 m/s"),
        "Speed at which the platens close in on each other; under force control its cap.",
    )
    force_rate: Measure | None = key(
        Quantity({"N/s": "a force rate"}, POSITIVE, "1 kN/s"),
        "Rate at which the force on the platens grows.",
        default=None,
        default_text="needed for control force",
    )
    peak_drop: float = key(
        Number(Interval(above=0, below=1)),
        "Drop of the force, as a share of its maximum so far, that counts as breakage.",
        default=0.5,
    )
    end_drop: float = key(
        Number(Interval(above=0, most=1)),
        "Drop of the force, as a share of its maximum so far, at which a broken grain's test ends.",
        default=0.9,
    )
    platen_stiffness: Measure | None = key(
        Quantity({"N/m": "a total stiffness"}, POSITIVE, "3e10 N/m"),
        "Stiffness of the platens' side of a contact, normal and shear.",
        default=None,
        default_text="10 times that of an element",
    )
    platen_friction: float | None = key(
        Number(NOT_NEGATIVE),
        "Friction coefficient of the platens; a contact has the smaller of the two coefficients.",
        default=None,
        default_text="contact.friction_coefficient",
    )
    loop: Literal["GrainLoop", "InteractionLoop"] = key(
        Choice(("GrainLoop", "InteractionLoop")),
        "What computes forces and motion: Grus's fast engine, or YADE's own loop with NewtonIntegrator.",
        default="GrainLoop",
    )
    damping: float = key(
        Number(Interval(least=0, below=1)), "Coefficient of YADE's local damping.", default=0.2
    )
    time_step_safety: float = key(
        Number(Interval(above=0, most=1)), "Time step over the critical one.", default=0.5
    )
    max_strain: float = key(
        Number(Interval(above=0, below=1)),
        "Closure at which a test without breakage ends, as a share of the initial platen gap.",
        default=0.2,
    )
    record_interval: float = key(
        Number(Interval(above=0, below=1)),
        "Closure between two rows of the record, as a share of the initial platen gap.",
        default=1e-4,
    )

    @staticmethod
    def problems(section: Any) -> Iterator[Problem]:
        check = must_be_given if section.control == "force" else must_be_absent
        yield from check(section, ["force_rate"], f"control {section.control}")
        if section.record_interval >= section.max_strain:
            yield Problem("the record would be empty", "less than max_strain", "record_interval")
