"""`grus mechanisms`: what a real oedometer test has and a plain run leaves out."""

from textwrap import fill
from typing import Optional

import typer
from rich.console import Console
from rich.markup import escape
from rich.table import Table

from grus.errors import GrusError

WIDTH = 120


def mechanisms(
    name: Optional[str] = typer.Argument(
        None, help="Mechanism to tell more of.", show_default="all, a line each"
    )
) -> None:
    """List the mechanisms that can be added to a test, with their parameters."""
    from grus.mechanisms import MECHANISMS

    if name is None:
        _list(MECHANISMS.values())
    elif name in MECHANISMS:
        _show(MECHANISMS[name])
    else:
        raise GrusError(f"mechanism = {name}: unknown; allowed: {', '.join(MECHANISMS)}")


def _list(known) -> None:
    table = Table(box=None, pad_edge=False)
    for title in ("mechanism", "acts on", "parameters", "what it is"):
        table.add_column(title, no_wrap=title != "parameters")
    for one in known:
        units = [f"{p.name} [{p.unit}]" for p in one.parameters]
        table.add_row(one.name, one.acts_on, escape(", ".join(units)), one.title)
    Console(width=WIDTH).print(table)


def _show(one) -> None:
    print(f"{one.name}: {one.title}, acts on the {one.acts_on}\n")
    for text in (one.summary, f"Signs: {one.signs}"):
        print(fill(text, WIDTH) + "\n")
    table = Table(box=None, pad_edge=False)
    for title in ("parameter", "unit", "from", "to", "sizes", "meaning"):
        table.add_column(title)
    for p in one.parameters:
        sizes = ", ".join(f"{size:g}" for size in p.sizes)
        table.add_row(p.name, p.unit, f"{p.low:g}", f"{p.high:g}", sizes, p.meaning)
    Console(width=WIDTH).print(table)
    print(f"\nSee docs/{one.page}.md")
