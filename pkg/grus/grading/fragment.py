"""Fragments of a specimen: what a sieve would take for one grain."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from grus.grading.curve import Grading
from grus.grading.feret import principal_widths
from grus.specimen import Specimen
from grus.specimen.clump_properties import element_volume
from grus.specimen.require import require, require_positive
from grus.specimen.touching import connected_parts

SIZES = ("sieve", "equivalent")


@dataclass(frozen=True, eq=False)
class Fragments:
    """Sets of clumps held together by bonds, from the one with the largest volume down.

    specimen: what they are fragments of. Sizes are those of its undeformed shape, so that nothing
        but breakage changes them.
    label (n,): index of the fragment of each element.
    grain (f,): index of the grain that each fragment comes from.
    volume (f,): of its elements [m3], the pores between them not included.
    equivalent_diameter (f,): of the circle of equal area or sphere of equal volume [m], pores
        included: the diameter of the grain's outline times the root (2nd or 3rd) of the fragment's
        share of the volume of the grain's elements. An unbroken grain has that of its outline.
    """

    specimen: Specimen
    label: np.ndarray
    grain: np.ndarray
    volume: np.ndarray
    equivalent_diameter: np.ndarray

    @classmethod
    def of_bonds(cls, specimen: Specimen, bonds: np.ndarray) -> "Fragments":
        """Fragments left by the bonds that hold, pairs (b, 2) of elements.

        Raises GrusError when bonds join grains or elements that do not exist.
        """
        pairs = np.asarray(bonds, dtype=np.int64).reshape(-1, 2)
        known = not pairs.size or (0 <= pairs.min() and pairs.max() < specimen.element_count)
        require(known, "bonds", "unknown elements", f"pairs of 0..{specimen.element_count - 1}")
        part = connected_parts(specimen.clump_count, specimen.clump[pairs])
        return cls.of_labels(specimen, part[specimen.clump])

    @classmethod
    def of_labels(cls, specimen: Specimen, label: np.ndarray) -> "Fragments":
        """Fragments given by any whole number (n,) for each element, as a snapshot holds them.

        With `specimen.grain` as label these are the unbroken grains. Raises GrusError for another
        length and when a fragment has elements of several grains.
        """
        count = specimen.element_count
        require(np.shape(label) == (count,), "shape of label", np.shape(label), f"({count},)")
        _, first, part = np.unique(label, return_index=True, return_inverse=True)
        grain = specimen.grain[first]
        mixed = np.flatnonzero(grain[part] != specimen.grain)
        require(not len(mixed), "label", np.ravel(label)[mixed[:1]], "of elements of one grain")
        solid = element_volume(specimen)
        volume = np.bincount(part, weights=solid)
        order = np.lexsort((first, -volume))
        rank = np.empty(len(order), dtype=np.int64)
        rank[order] = np.arange(len(order))
        grain, volume = grain[order], volume[order]
        share = volume / np.bincount(specimen.grain, weights=solid)[grain]
        diameter = specimen.grain_diameter[grain] * share ** (1 / specimen.dimension)
        return cls(specimen, rank[part], grain, volume, diameter)

    @property
    def count(self) -> int:
        """Number of fragments f."""
        return len(self.volume)

    def mass(self, density: float) -> np.ndarray:
        """Mass (f,) [kg] for elements of the given density [kg/m3]; their sum never changes."""
        require_positive("density", density, "kg/m3")
        return density * self.volume

    @cached_property
    def sieve_size(self) -> np.ndarray:
        """Size (f,) of the smallest opening that each fragment passes [m].

        In the plane its smallest Feret width, a slot; in space the second principal Feret width,
        which lets it lengthwise through a square opening. Both are those of the convex hull of the
        elements, radii included. Raises GrusError when elements of a grain differ in radius.
        """
        radius = self.specimen.radius
        own = np.zeros(self.specimen.grain_count)
        own[self.specimen.grain] = radius
        unequal = np.flatnonzero(own[self.specimen.grain] != radius)
        found = f"differs in grain {self.specimen.grain[unequal[:1]]}"
        require(not len(unequal), "radius", found, "one in a grain, for sieve sizes")
        dimension = self.specimen.dimension
        place = self.specimen.position[np.argsort(self.label, kind="stable"), :dimension]
        ends = np.cumsum(np.bincount(self.label))[:-1]
        inner = [principal_widths(part)[dimension - 2] for part in np.split(place, ends)]
        return np.array(inner) + 2 * own[self.grain]

    def grading(self, sieves: np.ndarray | None = None, size: str = "sieve") -> Grading:
        """Grading by mass.

        sieves: openings [m], rising; the series R20 over all sizes by default. size: `sieve` for
        the sieve size, `equivalent` for the equivalent diameter.
        """
        require(size in SIZES, "size", size, " or ".join(SIZES))
        sizes = self.sieve_size if size == "sieve" else self.equivalent_diameter
        return Grading.of_masses(sizes, self.volume, sieves)
