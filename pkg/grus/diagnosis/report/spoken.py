"""Numbers in the units and with the digits that an engineer uses."""

from grus.diagnosis.estimate import Estimate
from grus.plotting.labels import significant

DAY = 86400.0
_SCALES: dict[str, tuple[tuple[float, str], ...]] = {
    "s": ((1, "s"), (60, "min"), (3600, "h"), (DAY, "d"), (365.25 * DAY, "years")),
    "Pa": ((1, "Pa"), (1e3, "kPa"), (1e6, "MPa"), (1e9, "GPa")),
    "m": ((1e-6, "µm"), (1e-3, "mm"), (1, "m")),
    "m/Pa": ((1e-12, "µm/MPa"),),
    "m/s": ((1e-3, "mm/s"), (1, "m/s")),
    "1/s": ((0.01 / DAY, "% a day"),),
    "Pa/s": ((1e3 / DAY, "kPa a day"),),
}
"""Size and name of the units, small to large, in which a value in SI is told."""


def quantity(value: float, unit: str) -> str:
    """A value in SI with its unit, as in "4.4 h" or "10 µm/MPa"; unit "1" for pure numbers."""
    if unit == "1":
        return number(value)
    scales = _SCALES.get(unit, ((1, unit),))
    fitting = [one for one in scales if abs(value) >= 0.9995 * one[0]] or [scales[0]]
    size, name = fitting[-1]
    return f"{number(value / size)} {name}"


def number(value: float) -> str:
    """With two significant digits or all before the point, without zeros at the end."""
    text = significant(value, 2 if abs(value) < 99.5 else 3)
    return text.rstrip("0").rstrip(".") if "." in text and "e" not in text else text


def strain(value: float) -> str:
    """In per cent, as in "0.21 %"."""
    if abs(value) < 5e-7:
        return "0 %"
    return f"{number(100 * value)} %"


def probability(value: float) -> str:
    """In per cent, never certain."""
    if value > 0.99:
        return "over 99 %"
    return "below 1 %" if value < 0.01 else f"{100 * value:.0f} %"


def chances(p: float) -> str:
    """A p-value, as in "p = 0.25"."""
    return "p < 0.001" if p < 0.001 else f"p = {number(p)}"


def size(one: Estimate) -> str:
    """A parameter with its interval and whether it lies beyond what was run."""
    name = one.name.replace("_", " ")
    beyond = ", beyond the values that were run" if one.outside else ""
    low, high = quantity(one.low, one.unit), quantity(one.high, one.unit)
    return f"{name} {quantity(one.value, one.unit)} (90 %: {low} to {high}{beyond})"
