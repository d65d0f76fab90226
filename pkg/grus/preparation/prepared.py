"""A specimen that is ready for its test."""

from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy as np

from grus.errors import GrusError
from grus.files import replacing
from grus.specimen import Specimen, element_volume

FORMAT = "grus prepared specimen 1"
NUMBERS = ("axial_stress", "side_stress", "unbalanced", "largest_tension", "largest_shear")


@dataclass(frozen=True)
class PreparedSpecimen:
    """Grains at rest between the walls of a box, to be found there again by their contacts.

    specimen: the elements. Each grain has its undeformed shape, so that its bonds are without force where it stands.
        Contacts of grains are their overlaps, which carry the seating stress; they hold no shear force yet.
    lower, upper (dimension,): the corners of the box [m]. The last axis is that of loading.
    axial_stress, side_stress: mean normal stress on the platens and on the sides at the end of the preparation [Pa].
    unbalanced: mean resultant force over mean contact force then [-].
    largest_tension, largest_shear: of any bond then, [Pa] for parallel and [N] for contact bonds.
    key: hash of what made it.
    """

    specimen: Specimen
    lower: np.ndarray
    upper: np.ndarray
    axial_stress: float
    side_stress: float
    unbalanced: float
    largest_tension: float
    largest_shear: float
    key: str

    @property
    def box_volume(self) -> float:
        """Volume between the walls [m3]."""
        plane = self.specimen.thickness if self.specimen.dimension == 2 else 1.0
        return float(np.prod(self.upper - self.lower) * plane)

    @property
    def height(self) -> float:
        """Distance of the platens [m]."""
        return float(self.upper[-1] - self.lower[-1])

    @property
    def outline_volume(self) -> float:
        """Volume of the grains by their outlines [m3]: circles or spheres of their diameters."""
        return outline_volume(self.specimen)

    @property
    def void_ratio(self) -> float:
        """Void ratio by the outlines of the grains [-]."""
        return self.box_volume / self.outline_volume - 1

    @property
    def void_ratio_elements(self) -> float:
        """Void ratio by the elements [-]; the pores inside grains count as voids."""
        return self.box_volume / float(element_volume(self.specimen).sum()) - 1

    def save(self, path: str | Path) -> None:
        """Writes an HDF5 file, complete or not at all."""
        with replacing(path) as partial, h5py.File(partial, "w") as file:
            file.attrs["format"] = FORMAT
            file.attrs["key"] = self.key
            for name in NUMBERS:
                file.attrs[name] = getattr(self, name)
            file.create_dataset("lower", data=self.lower)
            file.create_dataset("upper", data=self.upper)
            self.specimen.write(file.create_group("specimen"))

    @classmethod
    def load(cls, path: str | Path) -> "PreparedSpecimen":
        """Reads what `save` wrote, bit by bit. Raises FileNotFoundError, or GrusError for anything else."""
        path = Path(path)
        if not path.exists():
            raise FileNotFoundError(f"{path}: does not exist")
        try:
            with h5py.File(path, "r") as file:
                if file.attrs.get("format") != FORMAT:
                    raise GrusError(f"{path}: not a file of the format '{FORMAT}'")
                return cls(
                    specimen=Specimen.read(file["specimen"]),
                    lower=file["lower"][()],
                    upper=file["upper"][()],
                    **{name: float(file.attrs[name]) for name in NUMBERS},
                    key=file.attrs["key"],
                )
        except (OSError, KeyError) as error:
            raise GrusError(f"{path}: cannot be read: {error}") from None


def outline_volume(specimen: Specimen) -> float:
    """Volume of the outlines of all grains [m3]: by their diameters, in the plane times the thickness."""
    d = specimen.grain_diameter
    if specimen.dimension == 2:
        return float(np.pi / 4 * (d**2).sum() * specimen.thickness)
    return float(np.pi / 6 * (d * d * d).sum())
