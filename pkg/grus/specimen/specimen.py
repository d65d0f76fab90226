"""The specimen: elements, clumps and grains as plain arrays."""

import hashlib
import json
from dataclasses import dataclass, field
from pathlib import Path

import h5py
import numpy as np

from grus.errors import GrusError
from grus.specimen.require import require, require_positive
from grus.specimen.store import read_file, read_group, write_file, write_group
from grus.specimen.touching import TOLERANCE, touching_pairs

ARRAYS = {
    "position": np.float64,
    "radius": np.float64,
    "clump": np.int64,
    "grain": np.int64,
    "grain_diameter": np.float64,
}


@dataclass(frozen=True, eq=False, kw_only=True)
class Specimen:
    """Elements (discs or spheres), the rigid clumps they form, and the grains these belong to.

    dimension: 2 (plane, z = 0) or 3.
    thickness: of a plane specimen [m]; without meaning when dimension is 3.
    position (n, 3): centres of the elements [m].
    radius (n,): of the elements [m].
    clump (n,): index 0..m-1 of the clump of each element; an element that stands alone is a
        clump of one member.
    grain (n,): index 0..g-1 of the grain of each element; a clump lies in one grain.
    grain_diameter (g,): equal-area (2D) or equal-volume (3D) diameter of the outlines [m].
    meta: what made the specimen, parameters and seed; anything that JSON can hold.

    The arrays are read-only copies. Two specimens are the same when their `content_hash` is.
    Raises GrusError, naming the array, when shapes, indices or signs are wrong.
    """

    dimension: int
    thickness: float = 1.0
    position: np.ndarray
    radius: np.ndarray
    clump: np.ndarray
    grain: np.ndarray
    grain_diameter: np.ndarray
    meta: dict = field(default_factory=dict)

    def __post_init__(self) -> None:
        for name, kind in ARRAYS.items():
            given = np.asarray(getattr(self, name))
            if kind is np.int64:
                require(bool((np.mod(given, 1) == 0).all()), name, "not whole", "whole numbers")
            value = np.array(given, dtype=kind, order="C")
            value.flags.writeable = False
            object.__setattr__(self, name, value)
        # Through JSON, so that what is saved and what is loaded are equal (tuples become lists).
        try:
            object.__setattr__(self, "meta", json.loads(json.dumps(self.meta, allow_nan=False)))
        except (TypeError, ValueError) as error:
            raise GrusError(f"meta = {error}: must be what JSON can hold") from None
        self._check()

    def _check(self) -> None:
        require(self.dimension in (2, 3), "dimension", self.dimension, "2 or 3")
        require_positive("thickness", self.thickness, "m")
        count = len(self.radius)
        require(count > 0, "number of elements", count, "at least 1")
        shape = self.position.shape
        require(shape == (count, 3), "shape of position", shape, f"({count}, 3)")
        require(bool(np.isfinite(self.position).all()), "position", "not finite", "finite")
        if self.dimension == 2:
            require(not self.position[:, 2].any(), "z of a plane specimen", "not 0", "0")
        _require_all_positive("radius", self.radius)
        _require_all_positive("grain_diameter", self.grain_diameter)
        _require_index("clump", self.clump, count)
        _require_index("grain", self.grain, count)
        grains = len(self.grain_diameter)
        require(
            self.grain_count == grains, "length of grain_diameter", grains, f"{self.grain_count}"
        )
        grain_of_clump = np.empty(self.clump_count, dtype=np.int64)
        grain_of_clump[self.clump] = self.grain
        astray = np.flatnonzero(grain_of_clump[self.clump] != self.grain)
        require(not len(astray), "grain", f"mixed in clump {self.clump[astray[:1]]}", "one a clump")

    @property
    def element_count(self) -> int:
        """Number of elements n."""
        return len(self.radius)

    @property
    def clump_count(self) -> int:
        """Number of clumps m, elements that stand alone included."""
        return int(self.clump.max()) + 1

    @property
    def grain_count(self) -> int:
        """Number of grains g."""
        return int(self.grain.max()) + 1

    def bonds(self, tolerance: float = TOLERANCE) -> np.ndarray:
        """Pairs (b, 2) int64 of elements to be bonded, i < j, sorted.

        They touch (gap <= tolerance times the smaller radius), lie in the same grain, and in
        different clumps: a clump is rigid and needs no bonds inside.
        """
        pairs = touching_pairs(self.position, self.radius, tolerance)
        first, second = pairs.T
        same_grain = self.grain[first] == self.grain[second]
        return pairs[same_grain & (self.clump[first] != self.clump[second])]

    def content_hash(self) -> str:
        """SHA-256 (hexadecimal) of all arrays and of meta; the same on every machine."""
        digest = hashlib.sha256()
        head = [int(self.dimension), float(self.thickness), self.meta]
        digest.update(json.dumps(head, sort_keys=True).encode())
        for name in ARRAYS:
            value = getattr(self, name)
            little = value.astype(value.dtype.newbyteorder("<"))
            digest.update(f"{name} {little.shape}".encode() + little.tobytes())
        return digest.hexdigest()

    def save(self, path: str | Path) -> None:
        """Write to an HDF5 file; an existing file is replaced, and never left half written."""
        write_file(path, *self._content())

    @classmethod
    def load(cls, path: str | Path) -> "Specimen":
        """Read what `save` wrote, bit by bit.

        Raises FileNotFoundError; ValueError when the file is of another kind or was changed.
        """
        return cls._of_content(path, *read_file(path))

    def write(self, group: h5py.Group) -> None:
        """Write into a group of an HDF5 file that holds other things too."""
        write_group(group, *self._content())

    @classmethod
    def read(cls, group: h5py.Group) -> "Specimen":
        """Read what `write` wrote; ValueError when the group is of another kind or was changed."""
        return cls._of_content(group.name, *read_group(group))

    def _content(self) -> tuple[dict[str, np.ndarray], dict, str]:
        arrays = {name: getattr(self, name) for name in ARRAYS}
        arrays |= {"dimension": np.int64(self.dimension), "thickness": np.float64(self.thickness)}
        return arrays, self.meta, self.content_hash()

    @classmethod
    def _of_content(
        cls, place: str | Path, arrays: dict[str, np.ndarray], meta: dict, digest: str
    ) -> "Specimen":
        dimension, thickness = int(arrays.pop("dimension")), float(arrays.pop("thickness"))
        specimen = cls(dimension=dimension, thickness=thickness, meta=meta, **arrays)
        same = specimen.content_hash() == digest
        require(same, "specimen", place, "the content whose hash is stored with it")
        return specimen


def _require_all_positive(name: str, value: np.ndarray) -> None:
    require(value.ndim == 1, f"number of axes of {name}", value.ndim, "1")
    bad = value[~((value > 0) & (value < np.inf))]
    require(not len(bad), name, bad[:1], "finite and > 0 m")


def _require_index(name: str, value: np.ndarray, count: int) -> None:
    require(value.shape == (count,), f"shape of {name}", value.shape, f"({count},)")
    require(int(value.min()) >= 0, f"lowest {name}", value.min(), ">= 0")
    missing = np.flatnonzero(np.bincount(value) == 0)
    require(not len(missing), name, f"without {missing[:1]}", "numbered 0, 1, ... without gaps")
