"""Errors of a model card."""

from collections.abc import Mapping, Sequence
from typing import Any

from grus.card.show import shorten, show
from grus.errors import GrusError, one_line

ABSENT = object()


class Problem(ValueError):
    """One thing that is wrong with a card: why, what is allowed, the dotted key and its value.

    Where the problem is found, the last three may not be known yet.
    """

    def __init__(self, reason: str, allowed: str = "", key: str = "", value: Any = ABSENT) -> None:
        super().__init__(reason, allowed, key, value)
        self.reason, self.allowed, self.key, self.value = reason, allowed, key, value

    def under(self, parent: str) -> "Problem":
        """The same problem, its key inside the table `parent`."""
        key = ".".join(part for part in (parent, self.key) if part)
        return Problem(self.reason, self.allowed, key, self.value)


class Problems(ValueError):
    """Several problems at once (`found`, in order)."""

    def __init__(self, found: Sequence[Problem]) -> None:
        super().__init__(tuple(found))
        self.found = tuple(found)


class CardError(GrusError):
    """A card is refused, in one line: `FILE: KEY = VALUE: what is wrong; allowed: ...`."""

    @classmethod
    def of(cls, source: str, problems: Sequence[Problem], card: Any = ABSENT) -> "CardError":
        """Tells the first of `problems` and counts the others; `card` holds the values."""
        first, more = problems[0], len(problems) - 1
        message = f"{one_line(source)}: "
        if first.key:
            value = _value(card, first.key) if first.value is ABSENT else first.value
            message += one_line(shorten(first.key))
            message += ": " if value is ABSENT else f" = {show(value)}: "
        message += one_line(first.reason)
        message += f"; allowed: {one_line(first.allowed)}" if first.allowed else ""
        return cls(message + (f" (and {more} more)" if more else ""))


def _value(card: Any, key: str) -> Any:
    for part in key.split("."):
        if not isinstance(card, Mapping) or part not in card:
            return ABSENT
        card = card[part]
    return card
