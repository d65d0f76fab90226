"""The keys of a table of targets."""

from collections.abc import Mapping, Sequence
from typing import Any

from grus.card.errors import Problem


def fields(
    table: Any, readers: Mapping[str, Any], needed: Sequence[str] = (), parent: str = ""
) -> dict[str, Any]:
    """Values of a table by its keys, each read by its reader; a key without one is taken as it is.

    Raises Problem, whose key stands under `parent`, for no table, an unknown key, a needed one that is missing, and what
    a reader refuses.
    """
    allowed = ", ".join(readers)
    if not isinstance(table, Mapping):
        raise Problem("not a table", f"a table with {allowed}", parent)
    found = {}
    for name, value in table.items():
        place = f"{parent}.{name}" if parent else name
        if name not in readers:
            raise Problem("unknown key", allowed, place)
        try:
            found[name] = value if readers[name] is None else readers[name].read(value)
        except Problem as problem:
            raise Problem(problem.reason, problem.allowed, place) from None
    for name in needed:
        if name not in found:
            raise Problem("is missing", allowed, f"{parent}.{name}" if parent else name)
    return found
