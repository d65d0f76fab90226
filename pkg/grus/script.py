"""What a YADE script is to run: the arguments of its command line, or a line of a table of yade-batch."""

import os
import sys
from pathlib import Path
from typing import Any

import yade.params
from yade import utils

from grus.card import Card
from grus.errors import GrusError, one_line

UNCHANGED = "*"
"""What YADE's tables have for a value that is left at its default: here, that of the card."""


def arguments(**others: Any) -> tuple:
    """The card, then a value for each of `others`, which are given with their defaults.

    On the command line stands the path of the card, then `others` in their order. In a table of yade-batch the column
    `card` has the path in quotes, columns named as `others` their values, and the further columns are keys of the card
    and override it. The default of `folder` is then results/TABLE/LINE, LINE being YADE's description of the line; it is
    made.
    Raises GrusError for a missing card or a value that cannot be read, naming table, line and what is allowed.
    """
    if os.environ.get("YADE_BATCH"):
        return _of_table(others)
    given = sys.argv[1:]
    if not 1 <= len(given) <= 1 + len(others):
        names = "".join(f" [{name.upper()}]" for name in others)
        raise GrusError(f"{len(given)} arguments; allowed: CARD{names}, or a table of yade-batch")
    found = others | {
        name: _like(others[name], text, name) for name, text in zip(others, given[1:])
    }
    return Card.from_file(given[0]), *found.values()


def _of_table(others: dict[str, Any]) -> tuple:
    table, number = os.environ["YADE_BATCH"].rsplit(":", 1)
    line = utils.TableParamReader(table).paramDict()[int(number)]
    where = f"{table}, line {number}"
    values = _values(line, where)
    if not isinstance(values.get("card"), str):
        raise GrusError(
            f"{where}: card = {values.get('card')!r}; allowed: a column card with the path of a card in quotes"
        )
    if "folder" in others:
        others = others | {"folder": str(Path("results", Path(table).stem, line["description"]))}
    changes = {name: value for name, value in values.items() if name not in {"card", *others}}
    try:
        found = {name: _like(others[name], values.get(name, others[name]), name) for name in others}
        card = Card.from_file(values["card"]).with_overrides(changes)
    except GrusError as error:
        raise GrusError(f"{where}: {error}") from None
    if "folder" in found:
        Path(found["folder"]).mkdir(parents=True, exist_ok=True)
    return card, *found.values()


def _values(line: dict[str, str], where: str) -> dict[str, Any]:
    """Values by column, read by YADE, which also puts them into its tags."""
    columns = {
        name: text for name, text in line.items() if name != "description" and name[0] != "!"
    }
    try:
        # YADE evaluates what it puts in for a value that is left at its default.
        utils.readParamsFromTable(**dict.fromkeys(columns, "None"))
    except Exception as error:  # whatever an expression may raise
        told = one_line(getattr(error, "text", None) or error)
        raise GrusError(
            f"{where}: {told}; allowed: numbers, and text in quotes without blanks, as '2MPa'"
        ) from None
    read = vars(yade.params.table)
    return {name: read[name] for name, text in columns.items() if text != UNCHANGED}


def _like(default: Any, value: Any, name: str) -> Any:
    """`value` as a whole number where the default is one, else as text."""
    if not isinstance(default, int):
        return value if value is None else str(value)
    try:
        return int(value)
    except ValueError:
        raise GrusError(f"{name} = {value!r}; allowed: a whole number") from None
