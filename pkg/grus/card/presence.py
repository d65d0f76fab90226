"""Keys that another key asks for or rules out."""

from collections.abc import Iterable, Iterator
from typing import Any

from grus.card.errors import Problem


def must_be_given(section: Any, names: Iterable[str], what: str) -> Iterator[Problem]:
    """A problem for each of `names` that is None although `what` needs it."""
    for name in names:
        if getattr(section, name) is None:
            yield Problem(f"is missing, {what} needs it", key=name)


def must_be_absent(section: Any, names: Iterable[str], what: str) -> Iterator[Problem]:
    """A problem for each of `names` that is given although `what` has no use for it."""
    for name in names:
        if getattr(section, name) is not None:
            yield Problem(f"{what} has no use for it", "leave the key out", name)
