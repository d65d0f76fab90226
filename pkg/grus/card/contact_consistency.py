"""What [contact] asks of the other tables."""

from collections.abc import Iterator
from typing import Any

from grus.card.errors import Problem


def contact_inconsistencies(card: Any) -> Iterator[Problem]:
    """Problems between [contact] and the tables of bonds and tests."""
    hertz = card.contact.law == "hertz"
    if card.bond.kind == "contact":
        if hertz:
            yield Problem(
                "not with contact bonds, which are linear springs", '"linear"', "contact.law"
            )
        if card.contact.unloading_ratio != 1:
            yield Problem(
                "not with contact bonds, which are elastic", "1", "contact.unloading_ratio"
            )
    if not hertz:
        return
    reason = "contact.law hertz has no use for it, platens and walls are rigid"
    if card.crush.platen_stiffness is not None:
        yield Problem(reason, "leave the key out", "crush.platen_stiffness")
    if card.oedometer is not None and card.oedometer.wall_stiffness is not None:
        yield Problem(reason, "leave the key out", "oedometer.wall_stiffness")
