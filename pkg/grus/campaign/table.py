"""A table of runs: a card, and what each run changes in it."""

from collections.abc import Sequence
from dataclasses import dataclass

from grus.campaign.plan import Overrides
from grus.campaign.run import Run
from grus.card import Card
from grus.errors import GrusError


@dataclass(frozen=True)
class Row:
    """One run; `changes` are the keys by which it differs from the card of the table."""

    changes: Overrides
    run: Run


def table(
    kind: str,
    card: Card,
    settings: Sequence[Overrides],
    seeds: Sequence[int] | None = None,
    grains: int = 1,
) -> list[Row]:
    """A row a setting, seed (default: that of the card) and grain.

    Raises CardError for a setting that the card refuses, and GrusError for several grains of anything but a crushing test.
    """
    if grains < 1 or (grains > 1 and kind != "crush"):
        raise GrusError(f"grains = {grains}; allowed: 1 or more, 1 in an oedometer")
    rows = []
    for setting in settings:
        for seed in [card.seed] if seeds is None else seeds:
            changes = setting if seeds is None else setting | {"seed": seed}
            changed = card.with_overrides(changes)
            for grain in range(grains):
                shown = changes | {"grain": grain} if grains > 1 else changes
                rows.append(Row(shown, Run(kind, changed, grain)))
    return rows
