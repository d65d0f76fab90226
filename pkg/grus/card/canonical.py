"""The form in which equal cards are equal: every key written out, in SI, in schema order."""

import hashlib
import json
from pathlib import Path
from typing import Any

from grus.card.program import Stage
from grus.card.pydantic_adapter import Section, keys
from grus.card.quantity import Measure

LABELS = ("name", "description")  # of no influence on any result


def plain(section: Section) -> dict[str, Any]:
    """Tables, texts and numbers as in TOML; keys that are absent for good are left out."""
    values = {name: getattr(section, name) for name in keys(type(section))}
    return {name: _plain(value) for name, value in values.items() if value is not None}


def _plain(value: Any) -> Any:
    if isinstance(value, Section):
        return plain(value)
    if isinstance(value, (Measure, Stage)):
        return value.written()
    return [_plain(item) for item in value] if isinstance(value, tuple) else value


def content_hash(card: dict[str, Any]) -> str:
    """SHA-256 of a plain card without its labels; a mesh counts by content, not by path."""
    content = {name: value for name, value in card.items() if name not in LABELS}
    if "mesh" in content["agglomerate"]:
        mesh = Path(content["agglomerate"]["mesh"]).read_bytes()
        digest = hashlib.sha256(mesh).hexdigest()
        content["agglomerate"] = {**content["agglomerate"], "mesh": digest}
    text = json.dumps(content, sort_keys=True, separators=(",", ":"), allow_nan=False)
    return hashlib.sha256(text.encode()).hexdigest()
