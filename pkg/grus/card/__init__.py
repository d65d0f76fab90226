"""Model card of Grus: TOML with units, checked once, an immutable object in SI after that."""

from grus.card.card import Card
from grus.card.errors import CardError

__all__ = ["Card", "CardError"]
