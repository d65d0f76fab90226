"""Refusal of bad input in one line."""

import math

from grus.errors import GrusError


def require(condition: bool, key: str, value: object, allowed: str) -> None:
    """Raise GrusError `key = value: must be allowed` unless `condition` holds."""
    if not condition:
        raise GrusError(f"{key} = {value}: must be {allowed}")


def require_positive(key: str, value: float, unit: str = "") -> None:
    """Raise GrusError unless `value` is finite and above zero."""
    require(0 < value < math.inf, key, value, f"finite and > 0 {unit}".rstrip())
