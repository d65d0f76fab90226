"""The model card of a command, with what `--set` changes in it."""

import typer

from grus.card import Card

MODEL = typer.Argument(..., help="Model card, a file in TOML.")
SET = typer.Option(
    [],
    "--set",
    help="Key and value instead of the card's, as bond.tensile_strength='3 MPa'; may be repeated.",
)


def model_card(model: str, settings: list[str]) -> Card:
    """Raises GrusError for a bad card or setting."""
    from grus.campaign.options import named, setting

    return Card.from_file(model).with_overrides(named(map(setting, settings)))
