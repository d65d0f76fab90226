"""Values as they appear in messages: short, printable, on one line."""

from collections.abc import Mapping
from typing import Any

from grus.errors import one_line

LONGEST = 60  # characters of a value that a message repeats


def shorten(text: str) -> str:
    """`text`, cut after LONGEST characters."""
    return text if len(text) <= LONGEST else text[:LONGEST] + "..."


def show(value: Any) -> str:
    """`value` as a card would write it, cut short."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return '"' + one_line(shorten(value)) + '"'
    if isinstance(value, int):
        # Python refuses to print integers of several thousand digits.
        bits = value.bit_length()
        return str(value) if bits < 100 else f"an integer of about {round(bits * 0.30103)} digits"
    if isinstance(value, float):
        return float.__repr__(value)
    if isinstance(value, Mapping):
        return "a table"
    if isinstance(value, (list, tuple)):
        return f"a list of {len(value)} items"
    return one_line(shorten(str(value)))
