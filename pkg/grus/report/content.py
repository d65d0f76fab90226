"""What stands on the page of a folder of results, whatever is in the folder."""

import re
from collections.abc import Sequence
from dataclasses import dataclass, field

import tomli_w

from grus.plotting.labels import prefixed

MEASURE = re.compile(r"(-?\d[\d.]*(?:e[-+]?\d+)?) ([A-Za-z]\S*)")
"""A number and its unit, as the card writes them."""


@dataclass(frozen=True)
class Grid:
    """A table: its title, its header, its rows."""

    title: str
    header: Sequence[str]
    rows: Sequence[Sequence[str]]


@dataclass(frozen=True)
class Picture:
    """A figure: its title, and the content of its file; kind: 'svg+xml' or 'png'."""

    title: str
    data: bytes
    kind: str


@dataclass(frozen=True)
class Content:
    """Everything that stands on the page.

    what: as "Crushing of grains". name: of the model. summary: what was found, as (name, text). card: all its keys;
    card_hash: when it was used. varied: keys that differ between runs, and what values they have. versions: by name. repeat: commands that give the
    same once more, `card.toml` being the card. notes: what a reader must know besides.
    """

    what: str
    name: str
    summary: Sequence[tuple[str, str]]
    pictures: Sequence[Picture]
    grids: Sequence[Grid]
    card: dict
    card_hash: str
    versions: dict[str, str]
    repeat: Sequence[str]
    varied: dict[str, str] = field(default_factory=dict)
    notes: Sequence[str] = ()

    @property
    def parameters(self) -> list[tuple[str, str]]:
        """Keys of the card and their values, those that differ between runs left out."""
        return [(key, value) for key, value in flat(self.card).items() if key not in self.varied]

    @property
    def toml(self) -> str:
        """The card as a file."""
        return tomli_w.dumps(self.card)


def flat(card: dict, parent: str = "") -> dict[str, str]:
    """Keys with dots, values as text."""
    found: dict[str, str] = {}
    for name, value in card.items():
        if isinstance(value, dict):
            found |= flat(value, f"{parent}{name}.")
        else:
            listed = value if isinstance(value, list) else [value]
            found[parent + name] = ", ".join(map(readable, listed))
    return found


def readable(value: object) -> str:
    """A value of a card as one would say it: six digits at most, and units with prefixes."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        return f"{value:.6g}"
    return MEASURE.sub(_measure, str(value))


def _measure(found: re.Match) -> str:
    number, unit = float(found[1]), found[2]
    if unit == "m":
        return f"{1e3 * number:.6g} mm"
    if unit in ("Pa", "N/m") and number:
        factor, unit = prefixed(abs(number), unit)
        return f"{factor * number:.6g} {unit}"
    return f"{number:.6g} {unit}"
