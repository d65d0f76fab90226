"""Keys that the schema does not have."""

import difflib
import re
from collections.abc import Iterator, Mapping
from typing import Any

from grus.card.errors import Problem
from grus.card.pydantic_adapter import Key, Section, keys
from grus.card.show import show
from grus.card.table import Table


def schema(section: type[Section], parent: str = "") -> Iterator[tuple[str, Key]]:
    """Every key with its dotted name, tables before what they hold."""
    for name, key in keys(section).items():
        yield parent + name, key
        if isinstance(key.reader, Table):
            yield from schema(key.reader.section, f"{parent}{name}.")


def split(card: Mapping[Any, Any], top: type[Section]) -> tuple[dict[str, Any], list[Problem]]:
    """A copy of `card` without its unknown keys, and a problem for each of these."""
    problems: list[Problem] = []

    def known(table: Mapping[Any, Any], section: type[Section], parent: str) -> dict[str, Any]:
        kept = {}
        for name, value in table.items():
            key = keys(section).get(name) if isinstance(name, str) else None
            if key is None:
                # A guess takes time, and only the first problem is told.
                guess = _guess(name, parent, section, top) if not problems else None
                problems.append(_unknown(name, value, parent, section, guess))
            elif isinstance(key.reader, Table) and isinstance(value, Mapping):
                kept[name] = known(value, key.reader.section, f"{parent}{name}.")
            else:
                kept[name] = value
        return kept

    return known(card, top, ""), problems


def _unknown(
    name: Any, value: Any, parent: str, section: type[Section], guess: str | None
) -> Problem:
    allowed = ", ".join(keys(section))
    if not isinstance(name, str):
        return Problem("a key that is not text", allowed, parent + show(name), value)
    hint = f", did you mean {guess}" if guess else ""
    bare = re.fullmatch("[A-Za-z0-9_-]+", name)
    return Problem(f"unknown key{hint}", allowed, parent + (name if bare else show(name)), value)


def _guess(name: Any, parent: str, section: type[Section], top: type[Section]) -> str | None:
    """The nearest key of the same table, else the key of that name in another table."""
    if not isinstance(name, str):
        return None
    name = name[:100]
    if close := difflib.get_close_matches(name, keys(section), n=1):
        return parent + close[0]
    leaves = {full.rpartition(".")[2]: full for full, _ in reversed(list(schema(top)))}
    close = difflib.get_close_matches(name, leaves, n=1, cutoff=0.85)
    return leaves[close[0]] if close else None
