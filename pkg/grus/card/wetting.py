"""[wetting]: what water does to the bonds."""

from grus.card.interval import POSITIVE, Interval
from grus.card.pydantic_adapter import Section, key
from grus.card.quantity import Measure, Quantity
from grus.card.values import Number


class Wetting(Section):
    """The specimen is wetted by a stage "wet", or at a laboratory time."""

    strength_factor: float = key(
        Number(Interval(above=0, most=1)),
        "Factor on the tensile and shear strength of all bonds (Oldecop & Alonso 2001).",
    )
    time: Measure | None = key(
        Quantity({"s": "a time"}, POSITIVE, "30 h"),
        "Laboratory time since the seating at which the specimen is wetted, within a hold or a load that takes time.",
        default=None,
        default_text='needed without a stage "wet", else left out',
    )
