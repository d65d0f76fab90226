"""Changes to single keys of a card."""

import copy
from collections.abc import Mapping
from typing import Any

from grus.card.errors import CardError, Problem
from grus.card.show import show


def overridden(
    written: Mapping[str, Any], overrides: Mapping[str, Any], source: str
) -> dict[str, Any]:
    """Copy of `written` with dotted keys set, or taken out where the value is None."""
    changed = copy.deepcopy(dict(written))
    for name, value in overrides.items():
        if not isinstance(name, str):
            raise CardError.of(
                source,
                [Problem("a key that is not text", 'for example "element.radius"', show(name))],
            )
        *tables, leaf = name.split(".")
        table = changed
        for part in tables:
            # A table that only a key to be taken out would need stays away.
            table = table.get(part, {}) if value is None else table.setdefault(part, {})
            if not isinstance(table, dict):
                raise CardError.of(
                    source, [Problem(f"unknown key, {part} is not a table", key=name)]
                )
        if value is None:
            table.pop(leaf, None)
        else:
            table[leaf] = value
    return changed
