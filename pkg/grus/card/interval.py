"""Bounds of a number."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Interval:
    """Numbers `above` or at `least` a bound, and `below` or at `most` another, where given."""

    above: float | None = None
    least: float | None = None
    below: float | None = None
    most: float | None = None

    def __contains__(self, x: float) -> bool:
        return (
            (self.above is None or x > self.above)
            and (self.least is None or x >= self.least)
            and (self.below is None or x < self.below)
            and (self.most is None or x <= self.most)
        )

    def text(self) -> str:
        """The interval in words, for example '> 0 and <= 1'."""
        signs = {">": self.above, ">=": self.least, "<": self.below, "<=": self.most}
        return " and ".join(f"{s} {x:g}" for s, x in signs.items() if x is not None)


POSITIVE = Interval(above=0)
NOT_NEGATIVE = Interval(least=0)
