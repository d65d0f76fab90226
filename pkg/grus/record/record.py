"""Time series of a test: named channels with units, and what was done to the specimen when."""

import json
from dataclasses import dataclass, field

import h5py
import numpy as np
import pandas as pd

from grus.errors import GrusError
from grus.record.segment import Segment

_ABOUT = "@about"  # a name that no channel has


@dataclass(frozen=True)
class Record:
    """Channels of equal length, each with a unit.

    channels: name -> values (n,), in the order of the test.
    units: name -> unit of the channel, SI, "1" for pure numbers.
    meta: what the record comes from (text and numbers).
    segments: the parts of the test in their order, empty when it has not been cut.
    notes: what was done to the readings before they became this record, a line each.
    Raises GrusError when lengths differ, a channel has no unit, or a segment ends after the last row.
    """

    channels: dict[str, np.ndarray]
    units: dict[str, str]
    meta: dict[str, str | float] = field(default_factory=dict)
    segments: tuple[Segment, ...] = ()
    notes: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        lengths = {name: len(values) for name, values in self.channels.items()}
        if len(set(lengths.values())) > 1:
            raise GrusError(f"record channels = {lengths}: lengths differ; allowed: one length")
        if set(self.units) != set(self.channels):
            odd = sorted(set(self.units) ^ set(self.channels))
            raise GrusError(f"record units = {odd}: every channel needs one unit")
        last = max((segment.last for segment in self.segments), default=-1)
        if last >= len(self):
            raise GrusError(f"record segments: end at row {last}; allowed: below {len(self)}")

    def __getitem__(self, name: str) -> np.ndarray:
        return self.channels[name]

    def __len__(self) -> int:
        return len(next(iter(self.channels.values()), ()))

    def frame(self) -> pd.DataFrame:
        """As a table whose headers carry the units: `force [N]`."""
        return pd.DataFrame(
            {f"{name} [{self.units[name]}]": v for name, v in self.channels.items()}
        )

    def write(self, group: h5py.Group) -> None:
        """Into an HDF5 group: one dataset a channel, with its unit as attribute; segments and notes in JSON."""
        for name, values in self.channels.items():
            group.create_dataset(name, data=values).attrs["unit"] = self.units[name]
        group.attrs["order"] = list(self.channels)
        group.attrs.update(self.meta)
        if self.segments or self.notes:
            about = {"segments": [s.to_dict() for s in self.segments], "notes": self.notes}
            # A dataset: attributes end at 64 kB.
            group.create_dataset(_ABOUT, data=json.dumps(about), dtype=h5py.string_dtype())

    @classmethod
    def read(cls, group: h5py.Group) -> "Record":
        """What `write` wrote, bit by bit."""
        order = [str(name) for name in group.attrs["order"]]
        meta = {key: value for key, value in group.attrs.items() if key != "order"}
        units = {name: str(group[name].attrs["unit"]) for name in order}
        about = json.loads(group[_ABOUT].asstr()[()]) if _ABOUT in group else {}
        segments = tuple(Segment(**segment) for segment in about.get("segments", ()))
        channels = {name: group[name][()] for name in order}
        return cls(channels, units, meta, segments, tuple(about.get("notes", ())))
