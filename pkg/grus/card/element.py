"""[element]: the elementary discs or spheres of which grains are made."""

from grus.card.interval import POSITIVE
from grus.card.pydantic_adapter import Section, key
from grus.card.quantity import Measure, Quantity


class Element(Section):
    """Elements are all of one size."""

    radius: Measure = key(
        Quantity({"m": "a length"}, POSITIVE, "0.6 mm"),
        "Radius of every element (of a disc when plane).",
    )
    density: Measure = key(
        Quantity({"kg/m^3": "a density"}, POSITIVE, "2052 kg/m^3"),
        "Density of the elements themselves.",
    )
