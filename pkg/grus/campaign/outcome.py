"""What a run has given, and its HDF5 form."""

import io
import json
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import h5py
import numpy as np

from grus.errors import GrusError
from grus.record import Record

if TYPE_CHECKING:
    from grus.campaign.run import Run

FORMAT = "grus campaign outcome 1"
PLAIN = ("key", "kind", "grain", "specimen_card", "failed", "refused", "log", "seconds")


@dataclass(frozen=True)
class Findings:
    """What a simulation has found: record, figures and arrays of its Outcome."""

    record: Record
    figures: dict[str, float]
    arrays: dict[str, np.ndarray] = field(default_factory=dict)


@dataclass(frozen=True)
class Outcome:
    """The end of one run, good or bad.

    key, kind, grain: those of the run. card, specimen_card: all keys of its cards, in SI; see `Card.from_dict`.
    record: of an oedometer what a laboratory would have recorded, of a crushing test force and displacement; None when
        the run failed.
    figures: numbers that were found, by dotted names as "bonds.broken", "energy.error", "peak.strength"; SI units.
    arrays: what else a test leaves, numbers or text of any shape by dotted names; of a crushing test all but its record,
        see `grus.crushing.arrays`; of an oedometer nothing.
    failed: what went wrong, in one line; None when nothing did. refused: the card is to blame, and every further try
        would fail as this one did. log: what the failed process has written.
    seconds: wall time of the simulation. versions: of Grus, YADE and Python.
    """

    key: str
    kind: str
    card: dict
    grain: int = 0
    record: Record | None = None
    figures: dict[str, float] = field(default_factory=dict)
    failed: str | None = None
    refused: bool = False
    log: str = ""
    seconds: float = 0.0
    versions: dict[str, str] = field(default_factory=dict)
    specimen_card: dict | None = None
    arrays: dict[str, np.ndarray] = field(default_factory=dict)

    def run(self) -> "Run":
        """The run whose end it is. Raises CardError when this version of Grus refuses the card."""
        # Here, so that Dask's workers do not wait for them.
        from grus.campaign.run import Run
        from grus.card import Card

        other = self.specimen_card and Card.from_dict(self.specimen_card, self.key[:12])
        return Run(self.kind, Card.from_dict(self.card, self.key[:12]), self.grain, other)

    @property
    def final(self) -> bool:
        """Whether another try would give the same: the run is done, or its card is to blame."""
        return self.failed is None or self.refused

    def to_bytes(self) -> bytes:
        """As an HDF5 file."""
        with h5py.File("outcome", "w", driver="core", backing_store=False) as file:
            file.attrs["format"] = FORMAT
            about = {name: getattr(self, name) for name in PLAIN}
            # Datasets: attributes end at 64 kB.
            for name, content in {
                "about": about,
                "card": self.card,
                "versions": self.versions,
            }.items():
                file.create_dataset(name, data=json.dumps(content), dtype=h5py.string_dtype())
            figures = file.create_group("figures")
            for name, value in self.figures.items():
                figures.create_dataset(name, data=float(value))
            arrays = file.create_group("arrays")
            for name, values in self.arrays.items():
                # numpy's own kind of text is not one of HDF5's.
                text = {"dtype": h5py.string_dtype()} if values.dtype.kind == "U" else {}
                arrays.create_dataset(name, data=values.astype(object) if text else values, **text)
            if self.record is not None:
                self.record.write(file.create_group("record"))
            file.flush()
            return file.id.get_file_image()

    @classmethod
    def from_bytes(cls, data: bytes) -> "Outcome":
        """What `to_bytes` has made. Raises GrusError for anything else."""
        try:
            with h5py.File(io.BytesIO(data), "r") as file:
                if file.attrs.get("format") != FORMAT:
                    raise GrusError(f"not a file of the format '{FORMAT}'")
                about, card, versions = (
                    json.loads(file[name].asstr()[()]) for name in ("about", "card", "versions")
                )
                return cls(
                    **about,
                    card=card,
                    versions=versions,
                    figures={name: float(value[()]) for name, value in file["figures"].items()},
                    # Outcomes of before there were any have none.
                    arrays={name: _array(data) for name, data in file.get("arrays", {}).items()},
                    record=Record.read(file["record"]) if "record" in file else None,
                )
        except (OSError, KeyError, ValueError, TypeError) as error:
            raise GrusError(f"cannot be read ({error})") from None


def _array(data: h5py.Dataset) -> np.ndarray:
    text = h5py.check_string_dtype(data.dtype)
    return np.array(data.asstr()[()], dtype=str) if text else np.array(data[()])
