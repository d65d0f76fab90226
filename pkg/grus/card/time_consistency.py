"""What [ageing] and [wetting] ask of the other tables."""

from collections.abc import Iterator
from typing import Any

from grus.card.bond import STRENGTH_UNIT, STRENGTH_UNITS
from grus.card.errors import Problem


def time_inconsistencies(card: Any) -> Iterator[Problem]:
    """Problems between bonds that change with time and the rest of the card."""
    for name in ("ageing", "wetting"):
        if getattr(card, name) is None:
            continue
        if card.oedometer is None:
            yield Problem("has no use without [oedometer]", "leave the table out", name)
        if card.bond.kind == "none":
            yield Problem("bond.kind none has no use for it", "leave the table out", name)
    if card.ageing is not None and card.bond.kind != "none":
        yield from _ageing(card.ageing, card.bond.kind)
    if card.oedometer is not None:
        yield from _wetting(card.wetting, card.oedometer.stages)


def _ageing(ageing: Any, kind: str) -> Iterator[Problem]:
    if ageing.law == "corrosion" and kind != "parallel":
        reason = f"a {kind} bond has no diameter that corrodes"
        yield Problem(reason, '"power"', "ageing.law")
    unit = STRENGTH_UNIT[kind]
    if ageing.threshold > 0 and ageing.threshold.unit != unit:
        reason = f"a {kind} bond needs {STRENGTH_UNITS[unit]}"
        yield Problem(reason, f"{STRENGTH_UNITS[unit]} [{unit}] >= 0", "ageing.threshold")


def _wetting(wetting: Any, stages: Any) -> Iterator[Problem]:
    count = sum(stage.kind == "wet" for stage in stages)
    if count > 1:
        yield Problem(f'{count} stages "wet"', "one at most", "oedometer.stages")
    if wetting is None:
        if count:
            reason = 'a stage "wet" needs wetting.strength_factor'
            yield Problem(reason, "a table [wetting]", "oedometer.stages")
        return
    if (count > 0) == (wetting.time is not None):
        reason = 'a stage "wet" says when' if count else 'is missing without a stage "wet"'
        yield Problem(reason, "one of both", "wetting.time")
    last = sum(stage.duration or 0.0 for stage in stages)
    if wetting.time is not None and wetting.time >= last:
        reason = f"the stages take {last:g} s"
        yield Problem(reason, "a time before their end", "wetting.time")
