"""The schema as text, with the values of a card where there is one."""

import textwrap
from collections.abc import Iterable, Mapping
from typing import Any

from grus.card.pydantic_adapter import Key, Section
from grus.card.quantity import Measure, Quantity
from grus.card.show import show
from grus.card.table import Table

WIDTH = 100


def explain(
    schema: Iterable[tuple[str, Key]],
    card: Section | None = None,
    written: Mapping[str, Any] | None = None,
) -> str:
    """A paragraph per key of `schema`; `card` gives the values, `written` how they were written."""
    lines: list[str] = []
    for name, key in schema:
        if isinstance(key.reader, Table):
            needed = "needed" if not key.default else f"default: {key.default}"
            lines += ["", f"[{name}]  {key.meaning} ({needed})"]
        else:
            lines += _paragraph(name, key, card, written)
    return "\n".join(lines)


def _paragraph(name: str, key: Key, card: Section | None, written: Any) -> list[str]:
    head = name.rpartition(".")[2]
    if card is not None:
        head = f"{head:<24} = {_value(_find(card, name))}   ({_origin(written, name)})"
    facts = f"default: {key.default or 'none, needed'}; allowed: {key.reader.allowed}"
    if isinstance(key.reader, Quantity):
        facts = (
            f'unit: {" or ".join(key.reader.units)}, for example "{key.reader.example}"; {facts}'
        )
    return [head, *_wrapped(key.meaning), *_wrapped(facts)]


def _value(value: Any) -> str:
    if isinstance(value, Measure):
        return f"{value:.12g} {value.unit}"
    return "-" if value is None else show(value)


def _origin(written: Any, name: str) -> str:
    value = _find(written, name)
    return "not written" if value is None else f"written {show(value)}"


def _find(table: Any, name: str) -> Any:
    for part in name.split("."):
        table = table.get(part) if isinstance(table, Mapping) else getattr(table, part, None)
    return table


def _wrapped(text: str) -> list[str]:
    return textwrap.wrap(text, WIDTH, initial_indent="    ", subsequent_indent="      ")
