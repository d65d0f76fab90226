"""Folders of results belong to one card."""

import json
from pathlib import Path

from grus.card import Card
from grus.errors import GrusError
from grus.files import write_text
from grus.version import __version__

OWNER = "card.json"


def claim(folder: str | Path, card: Card) -> str:
    """Makes `folder` that of the results of `card` and returns the key of these results.

    The card is written into it as card.json. Raises GrusError when the folder belongs to another card, or to nobody
    that can be told.
    """
    folder = Path(folder)
    key = f"{card.content_hash()} {__version__}"
    owner = folder / OWNER
    if owner.exists():
        try:
            other = json.loads(owner.read_text())["key"] != key
        except (ValueError, KeyError, TypeError):
            raise GrusError(f"{owner}: damaged, or not of Grus; allowed: an empty folder") from None
        if other:
            raise GrusError(
                f"{folder}: holds results of another card or version; "
                "allowed: an empty folder, or the same card"
            )
    folder.mkdir(parents=True, exist_ok=True)
    write_text(owner, json.dumps({"key": key, "card": card.to_dict()}, indent=1))
    return key
