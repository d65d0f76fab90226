"""[bond.scatter], [bond.grain_scatter]: how strength differs between bonds and between grains."""

from collections.abc import Iterator
from typing import Any, Literal

from grus.card.errors import Problem
from grus.card.interval import POSITIVE, Interval
from grus.card.presence import must_be_absent, must_be_given
from grus.card.pydantic_adapter import Section, key
from grus.card.quantity import Measure, Quantity
from grus.card.values import Choice, Number


class Scatter(Section):
    """Strength factor of each bond by itself."""

    kind: Literal["none", "normal", "weibull"] = key(
        Choice(("none", "normal", "weibull")),
        "Distribution of the factor: normal (mean 1, truncated to 0 to 2) or Weibull "
        "(characteristic value 1).",
        default="none",
    )
    coefficient_of_variation: float | None = key(
        Number(Interval(above=0, below=1)),
        "Standard deviation over mean of the normal factor.",
        default=None,
        default_text="needed for normal scatter",
    )
    modulus: float | None = key(
        Number(POSITIVE),
        "Weibull modulus of the factor.",
        default=None,
        default_text="needed for weibull scatter",
    )

    @staticmethod
    def problems(section: Any) -> Iterator[Problem]:
        for kind, name in {"normal": "coefficient_of_variation", "weibull": "modulus"}.items():
            check = must_be_given if section.kind == kind else must_be_absent
            yield from check(section, [name], f"scatter of kind {section.kind}")


class GrainScatter(Section):
    """Strength factor that all bonds of a grain share: Weibull, characteristic value 1."""

    modulus: float = key(Number(POSITIVE), "Weibull modulus of the factor.")
    reference_diameter: Measure | None = key(
        Quantity({"m": "a length"}, POSITIVE, "12.6 mm"),
        "Diameter d0 of a grain whose factor has the characteristic value 1; the factor then "
        "follows (d/d0)^(-dimension/modulus).",
        default=None,
        default_text="none: no size effect",
    )
