"""What a mechanism is: something that a real oedometer test has and a plain run leaves out."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Literal

from grus.card import Card
from grus.errors import GrusError
from grus.record import Record

Values = Mapping[str, float]
"""Values of parameters by their names, in the units of these."""


@dataclass(frozen=True)
class Parameter:
    """One parameter of a mechanism, in SI.

    unit: as pint reads it, "1" for pure numbers. low, high: bounds. sizes: values at which a fingerprint is taken, from
    weak to strong; the first is the one that is taken when no value is given. logarithmic: interpolated and searched in the
    logarithm. off: value without effect, if there is a finite one.
    """

    name: str
    unit: str
    low: float
    high: float
    sizes: tuple[float, ...]
    logarithmic: bool
    meaning: str
    off: float | None = None

    def check(self, value: float, mechanism: str) -> float:
        """The value; GrusError when it is out of bounds and not `off`."""
        if value == self.off or self.low <= value <= self.high:
            return float(value)
        raise GrusError(
            f"{mechanism}.{self.name} = {value:g}: out of bounds; "
            f"allowed: {self.low:g} to {self.high:g} {self.unit}"
        )


def _same_card(card: Card, values: Values) -> Card:
    return card


def _same_record(record: Record, values: Values) -> Record:
    return record


@dataclass(frozen=True)
class Mechanism:
    """A mechanism with its parameters; the first is the size of the effect.

    acts_on: what it changes. summary: what it does to a test, in the words of a geotechnical engineer. signs: what in a recording
    gives it away. on_card, on_record: what it makes of a card and of a record, from checked values of all parameters.
    """

    name: str
    title: str
    acts_on: Literal["bond", "contact", "test", "instrument"]
    parameters: tuple[Parameter, ...]
    summary: str
    signs: str
    on_card: Callable[[Card, Values], Card] = _same_card
    on_record: Callable[[Record, Values], Record] = _same_record

    @property
    def page(self) -> str:
        """Its page among the docs, without suffix."""
        return f"mechanisms/{self.name}"

    def apply(self, card: Card, values: Values) -> Card:
        """The card with the mechanism on; the same card for one of the instrument.

        values: parameters that are left out have the first of their sizes. Raises GrusError for unknown ones, values out of
        bounds, and cards that the mechanism cannot act on.
        """
        return self.on_card(card, self.complete(values))

    def distort(self, record: Record, values: Values) -> Record:
        """What the instrument writes down of a test; the same record unless the mechanism is one of the instrument.

        Raises GrusError as `apply`.
        """
        return self.on_record(record, self.complete(values))

    def complete(self, values: Values) -> dict[str, float]:
        """Values of all parameters, checked."""
        known = {one.name: one for one in self.parameters}
        for name in values:
            if name not in known:
                raise GrusError(
                    f"{self.name}.{name}: no such parameter; allowed: {', '.join(known)}"
                )
        return {
            name: one.check(values.get(name, one.sizes[0]), self.name)
            for name, one in known.items()
        }
