"""The stages of a test as they are run, with the laboratory clock."""

from typing import NamedTuple

from grus.card import Card
from grus.oedometer.result import SEAT, stage_name


class Planned(NamedTuple):
    """A stage: from one axial stress to another [Pa], and the laboratory clock at its begin and end [s].

    timed: whether the stage takes laboratory time; a load without one is put on at once.
    """

    kind: str
    start: float
    stress: float
    begins: float
    ends: float
    timed: bool

    @property
    def name(self) -> str:
        """As in "load to 100 kPa"."""
        return stage_name(self.kind, self.stress)


def program(card: Card) -> list[Planned]:
    """Stages of a card; first the seating, which is before all time. A hold stays at the stress before."""
    seating = float(card.preparation.seating_stress)
    planned = [Planned(SEAT, seating, seating, 0.0, 0.0, False)]
    for stage in card.oedometer.stages:
        start, now = planned[-1].stress, planned[-1].ends
        stress = start if stage.rests else float(stage.stress)
        timed = stage.duration is not None
        ends = now + float(stage.duration) if timed else now
        planned.append(Planned(stage.kind, start, stress, now, ends, timed))
    return planned


def has_clock(planned: list[Planned]) -> bool:
    """Whether any stage says how long it takes; wetting alone does not."""
    return any(one.timed and one.kind != "wet" for one in planned)
