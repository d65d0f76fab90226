"""Named arrays and a meta dictionary in HDF5."""

import json
from pathlib import Path

import h5py
import numpy as np

from grus.files import replacing
from grus.specimen.require import require

FORMAT = "grus specimen 1"


def write_group(group: h5py.Group, arrays: dict[str, np.ndarray], meta: dict, digest: str) -> None:
    """Write into an HDF5 group; `digest` is the hash of the content, by which the reader can check it."""
    group.attrs["format"] = FORMAT
    group.attrs["content_hash"] = digest
    for name, value in arrays.items():
        group.create_dataset(name, data=value)
    # A dataset: attributes end at 64 kB, which the meta of many grains exceeds.
    group.create_dataset("meta", data=json.dumps(meta), dtype=h5py.string_dtype())


def read_group(group: h5py.Group) -> tuple[dict[str, np.ndarray], dict, str]:
    """Return (arrays, meta, digest) as they were written; ValueError when the group is of another kind."""
    place = f"{group.file.filename}{group.name}"
    require(group.attrs.get("format") == FORMAT, "specimen", place, f"of the format '{FORMAT}'")
    arrays = {name: group[name][()] for name in group if name != "meta"}
    return arrays, json.loads(group["meta"].asstr()[()]), group.attrs["content_hash"]


def write_file(path: str | Path, *content: object) -> None:
    """`write_group` into a file, which appears under its name only when it is complete."""
    with replacing(path) as partial, h5py.File(partial, "w") as file:
        write_group(file, *content)


def read_file(path: str | Path) -> tuple[dict[str, np.ndarray], dict, str]:
    """`read_group` from a file; FileNotFoundError, or ValueError when the file is not HDF5."""
    path = Path(path)
    if not path.exists():
        raise FileNotFoundError(f"specimen file = {path}: does not exist")
    require(h5py.is_hdf5(path), "specimen file", path, "an HDF5 file")
    with h5py.File(path, "r") as file:
        return read_group(file)
