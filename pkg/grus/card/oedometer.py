"""[oedometer]: staged compression of a specimen in a box with fixed sides."""

from collections.abc import Iterator
from typing import Any, Literal

from grus.card.errors import Problem
from grus.card.interval import NOT_NEGATIVE, POSITIVE, Interval
from grus.card.program import Program
from grus.card.pydantic_adapter import Section, key
from grus.card.quantity import Measure, Quantity
from grus.card.values import Choice, Number, Whole


class Oedometer(Section):
    """Servo-controlled loading between two platens, stage by stage."""

    stages: tuple = key(Program(), "What is done to the specimen, in order.")
    speed: Measure = key(
        Quantity({"m/s": "a speed"}, POSITIVE, "0.01 m/s"),
        "Largest speed of each platen while bonds break or the test is not quasi-static.",
        default="0.01 m/s",
    )
    fast_speed: Measure | None = key(
        Quantity({"m/s": "a speed"}, POSITIVE, "0.1 m/s"),
        "Largest speed of each platen while nothing breaks and the test is quasi-static.",
        default=None,
        default_text="as speed",
    )
    tolerance: float = key(
        Number(Interval(above=0, below=1)),
        "Distance from the target at which a stress counts as reached, as a share of it.",
        default=0.01,
    )
    unbalanced_limit: float = key(
        Number(POSITIVE),
        "Largest unbalanced force of a specimen at rest, over the mean contact force.",
        default=0.01,
    )
    quiet_steps: int = key(
        Whole(1, 10**9),
        "Steps at rest that end a stage; three times as many after a bond has broken in it.",
        default=1000,
    )
    max_steps: int = key(
        Whole(1, 10**12),
        "Steps after which a stage that has not ended is given up.",
        default=20_000_000,
    )
    inertial_limit: float = key(
        Number(POSITIVE), "Largest inertial number of a quasi-static test.", default=0.001
    )
    platens: Literal["both", "top"] | None = key(
        Choice(("both", "top")),
        "Which platens move: both, or the top only, over a base that is fixed as the ring is; then the stress on the base is "
        "what wall friction leaves of it.",
        default=None,
        default_text="both",
    )
    wall_stiffness: Measure | None = key(
        Quantity({"N/m": "a total stiffness"}, POSITIVE, "3e9 N/m"),
        "Stiffness of the walls' side of a contact, normal and shear.",
        default=None,
        default_text="that of an element",
    )
    wall_friction: float = key(
        Number(NOT_NEGATIVE), "Friction coefficient of all walls.", default=0.0
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
    record_strain: float = key(
        Number(Interval(above=0, below=1)), "Strain between two rows of the record.", default=1e-4
    )
    record_stress: float = key(
        Number(Interval(above=0, below=1)),
        "Change of stress between two rows of the record, as a share of it.",
        default=0.02,
    )

    @staticmethod
    def problems(section: Any) -> Iterator[Problem]:
        if section.fast_speed is not None and section.fast_speed < section.speed:
            yield Problem("slower than speed", f"{section.speed:g} m/s or more", "fast_speed")
