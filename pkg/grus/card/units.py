"""Units, read by pint into exact factors, so that "12.6 mm" and "0.0126 m" are the same float."""

import re
from decimal import Decimal
from functools import lru_cache

import pint

_FACTOR = r"[A-Za-zµ°_]+(?:(?:\^|\*\*)-?[1-9]|[²³])?"
_UNIT = re.compile(rf"{_FACTOR}(?:\s*[*/·]\s*{_FACTOR}|\s+{_FACTOR}){{0,5}}")


@lru_cache(maxsize=None)
def _registry() -> pint.UnitRegistry:
    return pint.UnitRegistry(non_int_type=Decimal)


@lru_cache(maxsize=256)
def parse(unit: str) -> tuple[Decimal | None, pint.Unit]:
    """Factor to SI base units (None if it has an offset), and these; ValueError if unknown."""
    unit = unit.replace("\N{GREEK SMALL LETTER MU}", "\N{MICRO SIGN}")
    # Checked before pint sees it: pint would evaluate any formula, of any size.
    if not _UNIT.fullmatch(unit):
        raise ValueError(f'"{unit}" is not a unit')
    try:
        return _registry().get_base_units(_registry().parse_units(unit))
    except Exception as error:  # of many kinds: from the tokenizer, the registry or Decimal
        raise ValueError(f'unknown unit "{unit}"') from error


def factor(unit: str, si_unit: str) -> Decimal | None:
    """One `unit` in `si_unit`, None when they measure different things; ValueError if unknown."""
    scale, base = parse(unit)
    si_scale, si_base = parse(si_unit)
    return Decimal(scale) / Decimal(si_scale) if base == si_base and scale is not None else None


def long_name(unit: str) -> str:
    """Full name of a unit given by its symbol, '' for anything else."""
    name = str(_registry().parse_units(unit)) if unit.isalpha() else ""
    return name if name != unit else ""
