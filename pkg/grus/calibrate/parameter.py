"""A key of the card that is fitted."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Parameter:
    """A key of the card, and between which values it is sought.

    name: dotted, as "bond.tensile_strength". low, high: bounds in SI; unit: theirs, empty for a pure number.
    logarithmic: sought in the logarithm. tied: keys that always get the same value.
    A share says where between the bounds a value lies, 0 at `low` and 1 at `high`.
    """

    name: str
    low: float
    high: float
    unit: str = ""
    logarithmic: bool = False
    tied: tuple[str, ...] = ()

    def value(self, share: float) -> float:
        """The value at a share, with five digits, so that a calibrated card can be read."""
        if self.logarithmic:
            value = self.low * (self.high / self.low) ** share
        else:
            value = self.low + share * (self.high - self.low)
        return min(max(float(f"{value:.5g}"), self.low), self.high)

    def written(self, value: float) -> float | str:
        """As a card has it."""
        return f"{value!r} {self.unit}" if self.unit else value

    def overrides(self, value: float) -> dict[str, float | str]:
        """What a card with this value changes."""
        return {name: self.written(value) for name in (self.name, *self.tied)}
