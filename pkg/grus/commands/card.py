"""`grus card`: check a model card."""

from typing import Optional  # typer 0.7 does not know `str | None`

import click
import typer

from grus.card import Card


def card(
    file: Optional[str] = typer.Argument(
        None, help="Model card, a file in TOML.", show_default=False
    ),
    explain: bool = typer.Option(
        False, "--explain", help="Show every key: value, default, what is allowed, meaning."
    ),
) -> None:
    """Check a model card, or explain what may stand in one."""
    if file is None and not explain:
        raise click.UsageError(
            "give a FILE to check, or --explain to see the schema", click.get_current_context()
        )
    if file is None:
        print(Card.explain_schema())
        return
    checked = Card.from_file(file)
    good = f"{file}: good; content hash {checked.content_hash()[:12]}"
    print(checked.explain() if explain else good)
