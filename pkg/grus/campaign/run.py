"""One simulation of a campaign."""

import hashlib
import json
from dataclasses import dataclass
from functools import cached_property

from grus.card import Card
from grus.errors import GrusError
from grus.version import __version__

KINDS = ("crush", "oedometer", "recording")
OF_SPECIMENS = ("oedometer", "recording")


@dataclass(frozen=True)
class Run:
    """What is simulated: a test of a kind, on a card, with the card's seed.

    kind: 'crush'; 'oedometer'; or 'recording', an oedometer test of which only the laboratory's record is wanted, without
        the analysis of grading and yield. grain: number of the grain that is crushed; 0 in an oedometer, which takes all.
    specimen_card: card whose specimen an oedometer takes, None for `card` itself; see `grus.oedometer.oedometer`.
    Raises GrusError for another kind, a grain below 0, or a card without what the kind needs.
    """

    kind: str
    card: Card
    grain: int = 0
    specimen_card: Card | None = None

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise GrusError(f"kind = {self.kind!r}; allowed: {', '.join(map(repr, KINDS))}")
        if self.grain < 0 or (self.grain > 0 and self.kind != "crush"):
            raise GrusError(f"grain = {self.grain}; allowed: 0 or more, 0 in an oedometer")
        if self.kind in OF_SPECIMENS:
            for table in ("specimen", "oedometer"):
                if getattr(self.card, table) is None:
                    raise GrusError(
                        f"{self.card.source}: {table} is missing; allowed: a table [{table}]"
                    )

    @property
    def prepared_by(self) -> Card:
        """The card whose specimen is tested."""
        return self.specimen_card or self.card

    @cached_property
    def key(self) -> str:
        """SHA-256 of all that decides the outcome: kind, card with its seed, grain, specimen, version of Grus."""
        content = [self.kind, self.card.content_hash(), self.grain, __version__]
        if self.specimen_card is not None:
            content.append(self.specimen_card.content_hash())
        text = json.dumps(content)
        return hashlib.sha256(text.encode()).hexdigest()
