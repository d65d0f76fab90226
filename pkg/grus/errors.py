"""The base of the errors that Grus raises for input it refuses."""

import json
from typing import Any


class GrusError(ValueError):
    """Bad input: one line that names the key, its value and what is allowed."""


def one_line(text: Any) -> str:
    """`text` with every unprintable character (line breaks too) escaped, fit for a message."""
    text = str(text)
    return text if text.isprintable() else json.dumps(text)[1:-1].replace("\x7f", "\\x7f")
