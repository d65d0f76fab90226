"""Numbers of a calibration in words."""

from grus.plotting.labels import prefixed

PREFIXED = ("Pa", "N/m", "N", "Pa/m", "m")


def measured(value: float, unit: str) -> str:
    """A value in SI with a unit that reads well."""
    if unit == "1":
        return f"{value:.4g}"
    if unit in PREFIXED and value:
        factor, unit = prefixed(abs(value), unit)
        value *= factor
    return f"{value:.4g} {unit}"


def spread(parameter: dict, confidence: float) -> str:
    """The interval of a parameter, in brackets; parameter: of result.json."""
    if parameter["interval"] is None:
        return " (too few trials for an interval)"
    low, high = (measured(end, parameter["unit"]) for end in parameter["interval"])
    text = f" ({confidence:.0%} interval {low} to {high}"
    return text + (")" if parameter["fixed_by_targets"] else "; the targets do not fix it)")
