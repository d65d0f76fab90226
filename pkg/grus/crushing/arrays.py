"""A crushing test as named arrays, the form in which campaigns keep what a run leaves besides its record."""

import json
from collections.abc import Mapping

import numpy as np

from grus.crushing.result import CrushingResult
from grus.record import Record
from grus.scene.snapshot import Snapshot
from grus.specimen import Specimen

STATES = ("before", "after")


def to_arrays(result: CrushingResult) -> dict[str, np.ndarray]:
    """All of the result but its record: 'gap' and the other numbers without axes, 'before.position', 'specimen.radius'."""
    arrays = {name: np.array(value) for name, value in result.numbers.items()}
    for part in (*STATES, "specimen"):
        fields = vars(getattr(result, part)).items()
        arrays |= {f"{part}.{name}": np.array(value) for name, value in fields if name != "meta"}
    return arrays | {"specimen.meta": np.array(json.dumps(result.specimen.meta))}


def from_arrays(record: Record, arrays: Mapping[str, np.ndarray]) -> CrushingResult:
    """The result of which `to_arrays` has made `arrays`, bit by bit."""
    numbers = {name: value.item() for name, value in arrays.items() if "." not in name}
    states = {name: Snapshot(**_part(arrays, name)) for name in STATES}
    specimen = {
        name: value if value.ndim else value.item()
        for name, value in _part(arrays, "specimen").items()
    }
    specimen["meta"] = json.loads(specimen["meta"])
    return CrushingResult(**numbers, **states, record=record, specimen=Specimen(**specimen))


def _part(arrays: Mapping[str, np.ndarray], part: str) -> dict[str, np.ndarray]:
    """What follows `part` and a dot in the names."""
    start = f"{part}."
    return {
        name.removeprefix(start): value for name, value in arrays.items() if name.startswith(start)
    }
