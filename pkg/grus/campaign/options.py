"""Seeds, values and ranges as they stand on a command line."""

import re
from collections.abc import Collection, Iterable
from typing import Any, TypeVar

from grus.campaign.plan import Range
from grus.errors import GrusError

T = TypeVar("T")
NUMBER = r"[-+]?(?:\d+(?:\.\d+)?|\.\d+)(?:[eE][-+]?\d+)?"


def seeds(text: str) -> list[int]:
    """As "1-40,50". Raises GrusError."""
    found: list[int] = []
    for part in text.split(","):
        match = re.fullmatch(r"\s*(\d+)(?:-(\d+))?\s*", part)
        last = match and int(match[2] or match[1])
        if match is None or last < int(match[1]):
            raise GrusError(f"seeds = {text!r}; allowed: numbers and ranges, as 1-40,50")
        found += range(int(match[1]), last + 1)
    return found


def choices(text: str) -> tuple[str, list[Any]]:
    """Key and values of "bond.tensile_strength=1 MPa,2 MPa". Raises GrusError."""
    name, values = _split(text, "set", "as bond.tensile_strength=1 MPa,2 MPa")
    return name, [_value(value.strip()) for value in values.split(",")]


def setting(text: str) -> tuple[str, Any]:
    """Key and value of "bond.tensile_strength=3 MPa". Raises GrusError."""
    name, value = _split(text, "set", "as bond.tensile_strength=3 MPa")
    return name, _value(value.strip())


def span(text: str) -> tuple[str, Range]:
    """Key and range of "bond.tensile_strength=1..3 MPa". Raises GrusError."""
    example = "as bond.tensile_strength=1..3 MPa"
    name, values = _split(text, "vary", example)
    match = re.fullmatch(rf"\s*({NUMBER})\s*\.\.\s*({NUMBER})\s*(.*)", values)
    if match is None:
        raise GrusError(f"vary = {text!r}; allowed: a key and a range, {example}")
    return name, Range(float(match[1]), float(match[2]), match[3].strip())


def named(pairs: Iterable[tuple[str, T]], taken: Collection[str] = ()) -> dict[str, T]:
    """The pairs by their keys. Raises GrusError for a key that comes twice or is `taken` by another option."""
    found: dict[str, T] = {}
    for name, value in pairs:
        if name in found or name in taken:
            raise GrusError(f"{name}: given twice; allowed: all its values in one option")
        found[name] = value
    return found


def _split(text: str, option: str, example: str) -> tuple[str, str]:
    name, equals, values = text.partition("=")
    if not (name.strip() and equals and values.strip()):
        raise GrusError(f"{option} = {text!r}; allowed: a key and what it is set to, {example}")
    return name.strip(), values


def _value(text: str) -> Any:
    """As the card would have it: a number where it is one, else text."""
    if text in ("true", "false"):
        return text == "true"
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text
