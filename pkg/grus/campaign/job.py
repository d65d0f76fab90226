"""What a process is told to simulate; plain text, so that it can go to another machine."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from grus.campaign.run import Run
    from grus.card import Card

SPECIMEN = "specimen"
"""Kind of a job that prepares a specimen, which is then in the store."""


@dataclass(frozen=True)
class Job:
    """One process's work.

    store: its folder. kind: that of the run, or SPECIMEN. key: of the run or of the specimen. card: all its keys in
    SI; source: how messages name it. attempt: 0, and 1 when the first has failed. time_limit [s] and memory_limit
    [bytes] of the process, None without. until: time [s since 1970] after which nothing is begun. specimen_card: see
    Run, also in SI.
    """

    store: str
    kind: str
    key: str
    card: dict
    source: str
    grain: int = 0
    attempt: int = 0
    time_limit: float | None = None
    memory_limit: int | None = None
    until: float | None = None
    specimen_card: dict | None = None

    @property
    def identity(self) -> dict[str, Any]:
        """What an Outcome tells of its run."""
        names = ("key", "kind", "card", "grain", "specimen_card")
        return {name: getattr(self, name) for name in names}

    def run(self) -> "Run":
        """The run it stands for."""
        # Here, so that Dask's workers do not wait for it.
        from grus.campaign.run import Run

        other = self.specimen_card and _card(self.specimen_card, self.source)
        return Run(self.kind, self.made_card(), self.grain, other)

    def made_card(self) -> "Card":
        return _card(self.card, self.source)


def _card(keys: dict, source: str) -> "Card":
    from grus.card import Card

    return Card.from_dict(keys, source)
