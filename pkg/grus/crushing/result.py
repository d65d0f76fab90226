"""Outcome of the crushing of one grain."""

from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy as np

from grus.errors import GrusError
from grus.files import replacing
from grus.record import Record
from grus.scene.snapshot import Snapshot
from grus.specimen import Specimen

FORMAT = "grus crushing 1"


@dataclass(frozen=True)
class CrushingResult:
    """One grain, before, during and after its test.

    grain: its number, which with the card's seed fixes everything about it.
    gap: initial distance of the platens [m].
    area: over which the force is spread for the strength [m2]: gap^2, in the plane gap times thickness.
    peak_force: force before its first drop by the card's `crush.peak_drop` after a bond has broken [N]; 0 if there
        was no such drop.
    peak_closing: closing of the platens at that force [m].
    max_force: largest force of the whole test [N], at max_closing [m].
    ended: 'crushed' or 'strain' (the card's `crush.max_strain` was reached).
    bonds: number of bonds at the start; tension_breaks, shear_breaks: how many of them broke in each mode.
    record: time, closing, force, broken bonds by mode and energies of the test.
    before, after: the elements and bonds at the start and at the end.
    """

    grain: int
    gap: float
    area: float
    peak_force: float
    peak_closing: float
    max_force: float
    max_closing: float
    ended: str
    bonds: int
    tension_breaks: int
    shear_breaks: int
    record: Record
    before: Snapshot
    after: Snapshot
    specimen: Specimen

    @property
    def broken(self) -> bool:
        """Whether the force dropped by the given share."""
        return self.peak_force > 0

    @property
    def strength(self) -> float:
        """Peak force by the first drop over the area [Pa]; the largest force over the area if it never dropped."""
        return (self.peak_force or self.max_force) / self.area

    @property
    def max_strength(self) -> float:
        """Largest force over the area [Pa]."""
        return self.max_force / self.area

    @property
    def energy_error(self) -> float:
        """Work of the platens that no energy accounts for, at the end, over the work [-]."""
        r = self.record
        stored = r["elastic_energy"][-1] + r["kinetic_energy"][-1]
        lost = r["released_energy"][-1] + r["sliding_work"][-1] + r["damped_energy"][-1]
        work = r["work"][-1]
        return float((work - stored - lost) / work) if work > 0 else 0.0

    def summary(self) -> dict:
        """Numbers of the test, as plain JSON."""
        return {
            "grain": self.grain,
            "gap_m": self.gap,
            "broken": self.broken,
            "peak_force_N": self.peak_force,
            "peak_closing_m": self.peak_closing,
            "max_force_N": self.max_force,
            "max_closing_m": self.max_closing,
            "strength_Pa": self.strength,
            "max_strength_Pa": self.max_strength,
            "ended": self.ended,
            "elements": self.specimen.element_count,
            "clumps": self.specimen.clump_count,
            "bonds": self.bonds,
            "tension_breaks": self.tension_breaks,
            "shear_breaks": self.shear_breaks,
            "fragments": self.after.fragment_count,
            "energy_error": self.energy_error,
        }

    def save(self, path: str | Path, key: str) -> None:
        """Writes an HDF5 file, complete or not at all; `key` says what the result belongs to."""
        with replacing(path) as partial, h5py.File(partial, "w") as file:
            file.attrs.update({"format": FORMAT, "key": key} | self.numbers)
            self.record.write(file.create_group("record"))
            self.specimen.write(file.create_group("specimen"))
            for name, state in {"before": self.before, "after": self.after}.items():
                group = file.create_group(name)
                for field, values in vars(state).items():
                    group.create_dataset(field, data=values)

    @property
    def numbers(self) -> dict[str, float | int | str]:
        """What is neither a table nor an array, by the names of this class."""
        objects = {"record", "before", "after", "specimen"}
        return {name: value for name, value in vars(self).items() if name not in objects}

    @classmethod
    def load(cls, path: str | Path, key: str) -> "CrushingResult":
        """What `save` wrote with the same key. Raises GrusError for another key or a file that is not one of these."""
        try:
            with h5py.File(path, "r") as file:
                numbers = {name: _plain(value) for name, value in file.attrs.items()}
                if numbers.pop("format", None) != FORMAT or numbers.pop("key", None) != key:
                    raise GrusError(f"{path}: not a result of this card and version of Grus")
                states = {
                    name: Snapshot(**{field: file[name][field][()] for field in file[name]})
                    for name in ("before", "after")
                }
                record = Record.read(file["record"])
                specimen = Specimen.read(file["specimen"])
                return cls(**numbers, **states, record=record, specimen=specimen)
        except (OSError, KeyError) as error:
            raise GrusError(f"{path}: cannot be read as a crushing result ({error})") from None


def _plain(value: object) -> object:
    return value.item() if isinstance(value, np.generic) else value
