"""Defaults that depend on other keys."""

from collections.abc import Mapping
from typing import Any

from grus.card.contact import Contact
from grus.card.errors import Problem
from grus.card.pydantic_adapter import keys

THICKNESS = "1 m"  # of a plane model: forces are per metre


def with_defaults(card: Mapping[str, Any]) -> dict[str, Any]:
    """`card` with these defaults written out; what is wrong in it stays as it is."""
    filled = dict(card)
    if card.get("dimension") == 2:
        filled.setdefault("thickness", THICKNESS)
    bond = card.get("bond")
    if isinstance(bond, Mapping) and bond.get("kind") == "parallel":
        filled["bond"] = {"radius_ratio": 1, "moment_contribution": 1, **bond}
    contact, crush = card.get("contact"), card.get("crush")
    if isinstance(contact, Mapping) and isinstance(crush, Mapping):
        filled["crush"] = {**_friction(contact), **crush}
    if "specimen" in card:
        filled.setdefault("preparation", {})
    return filled


def _friction(contact: Mapping[str, Any]) -> dict[str, float]:
    """Platens as rough as the elements; nothing when that friction is wrong, to tell it once."""
    try:
        value = keys(Contact)["friction_coefficient"].reader.read(
            contact.get("friction_coefficient")
        )
    except Problem:
        return {}
    return {"platen_friction": value}
