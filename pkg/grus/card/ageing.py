"""[ageing]: how bonds lose strength with laboratory time (static fatigue)."""

from collections.abc import Iterator
from typing import Any, Literal

from grus.card.errors import Problem
from grus.card.interval import NOT_NEGATIVE, POSITIVE, Interval
from grus.card.presence import must_be_absent, must_be_given
from grus.card.pydantic_adapter import Section, key
from grus.card.quantity import Measure, Quantity
from grus.card.values import Choice, Number

LAWS = {"power": ("exponent", "reference_time"), "corrosion": ("beta1", "beta2")}
"""Keys that each law needs."""


class Ageing(Section):
    """Bonds age in holds and in loads that have a laboratory time."""

    law: Literal["power", "corrosion"] = key(
        Choice(tuple(LAWS)),
        "Power law (Charles 1958), which takes strength, or stress corrosion (Potyondy 2007), which takes the diameter of "
        "parallel bonds.",
        default="power",
    )
    exponent: float | None = key(
        Number(POSITIVE),
        "Exponent n of the power law.",
        default=None,
        default_text="needed for law power, else left out",
    )
    reference_time: Measure | None = key(
        Quantity({"s": "a time"}, POSITIVE, "1 h"),
        "Time t0 of the power law: a bond under a small constant stress lasts t0/(n + 1) (stress/strength)^-n.",
        default=None,
        default_text="needed for law power, else left out",
    )
    beta1: Measure | None = key(
        Quantity({"m/s": "a speed"}, POSITIVE, "1e-15 m/s"),
        "Rate at which the diameter of an almost unloaded bond falls by stress corrosion.",
        default=None,
        default_text="needed for law corrosion, else left out",
    )
    beta2: float | None = key(
        Number(NOT_NEGATIVE),
        "Growth of that rate with stress over strength: the rate is beta1 exp(beta2 stress/strength).",
        default=None,
        default_text="needed for law corrosion, else left out",
    )
    threshold: Measure = key(
        Quantity({"Pa": "a stress", "N": "a force"}, NOT_NEGATIVE, "0.1 MPa"),
        "Stress (of contact bonds: force) below which a bond does not age.",
        default="0 Pa",
    )
    humidity: float = key(
        Number(Interval(least=0, most=1)),
        "Relative humidity, to which the rate is proportional.",
        default=1,
    )

    @staticmethod
    def problems(section: Any) -> Iterator[Problem]:
        for law, names in LAWS.items():
            check = must_be_given if section.law == law else must_be_absent
            yield from check(section, names, f"law {section.law}")
