"""Units of a recording's columns, converted by pint."""

import re
from functools import lru_cache

import numpy as np
import pint

from grus.card.units import factor, long_name, parse
from grus.recording.channels import Channel

PURE = {"-": 1.0, "\N{EN DASH}": 1.0, "1": 1.0, "count": 1.0}
PURE |= {"counts": 1.0, "%": 1e-2, "percent": 1e-2, "\N{PER MILLE SIGN}": 1e-3}
"""Pure numbers, which pint has no common sign for."""
_POWER = re.compile(r"(?<=[A-Za-z])([23])(?![0-9A-Za-z])")
_DEGREE = re.compile(r"\N{DEGREE SIGN}\s*([CF])")


class UnitError(ValueError):
    """A unit that is not one of the channel; the message says why."""


def to_si(values: np.ndarray, unit: str, channel: Channel) -> np.ndarray:
    """Values (n,) of a channel in its SI unit; UnitError for a unit of another kind, and for one that is unknown."""
    if unit in PURE:
        if channel.unit != "1":
            raise UnitError(f'"{unit}" is not {channel.what}')
        return values * PURE[unit]
    # "kN/m2" and "°C", as laboratories write them
    written = _DEGREE.sub(r"deg\1", _POWER.sub(r"^\1", unit))
    try:
        parse(written)
    except ValueError as error:
        raise UnitError(str(error)) from None
    if channel.unit == "K":
        # With its zero: 20 degC are 293.15 K.
        if factor(written, "K") is not None:
            return _registry().Quantity(values, written).to("K").magnitude
    elif channel.unit != "1" or "/" in written:
        ratio = factor(written, "m/m" if channel.unit == "1" else channel.unit)
        if ratio is not None:
            return values * float(ratio)
    name = long_name(written)
    raise UnitError(f'"{unit}"{f" ({name})" if name else ""} is not {channel.what}')


@lru_cache(maxsize=None)
def _registry() -> pint.UnitRegistry:
    return pint.UnitRegistry()
