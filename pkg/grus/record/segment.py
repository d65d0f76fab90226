"""A stretch of a test in which one thing is done to the specimen."""

from dataclasses import asdict, dataclass, field
from typing import Any, Literal

from grus.errors import GrusError

Kind = Literal["seat", "load", "reload", "unload", "hold", "event"]
KINDS: tuple[Kind, ...] = ("seat", "load", "reload", "unload", "hold", "event")


@dataclass(frozen=True)
class Segment:
    """Rows `first` to `last` of a record, both included.

    Neighbours share the row at which one ends and the other begins, so that changes over all of them add up to the
    change over the test. An event is a jump of strain and lies inside another segment, whose stage it has.

    kind: "seat", "load", "reload" (up to the highest stress before), "unload", "hold" or "event". stage: number, 0 is
    the seating. t0, t1: time [s] of the first and last row, None without a time. stress_from, stress_to: axial stress
    [Pa] there, freed of noise. noise: standard deviation of a reading of each channel, in the unit of the channel.
    Raises GrusError for another kind and rows out of order.
    """

    kind: Kind
    stage: int
    first: int
    last: int
    t0: float | None
    t1: float | None
    stress_from: float
    stress_to: float
    noise: dict[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise GrusError(f"segment kind = {self.kind!r}; allowed: {', '.join(KINDS)}")
        if not 0 <= self.first <= self.last:
            raise GrusError(
                f"segment rows = {self.first} to {self.last}; allowed: 0 or more, in order"
            )

    @property
    def rows(self) -> slice:
        """The rows, to index a channel with."""
        return slice(self.first, self.last + 1)

    def to_dict(self) -> dict[str, Any]:
        """Numbers and text only, for JSON; `Segment(**d)` makes it again."""
        return asdict(self)
