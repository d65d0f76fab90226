"""Outline of a grain: the shape that its elements fill."""

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from grus.specimen.require import require_positive


class Outline(ABC):
    """A closed curve in the plane or a closed surface in space, with its centroid at the origin."""

    dimension: int
    """2 or 3."""

    @property
    @abstractmethod
    def measure(self) -> float:
        """Area [m2] in the plane, volume [m3] in space."""

    @property
    @abstractmethod
    def bounding_radius(self) -> float:
        """Largest distance of the outline from its centroid [m]."""

    @property
    @abstractmethod
    def box(self) -> np.ndarray:
        """Lower and upper corner (2, dimension) of the axis-parallel box around the outline [m]."""

    @abstractmethod
    def contains(self, points: np.ndarray, margin: float) -> np.ndarray:
        """Mask (n,) of the points (n, 3) [m] inside and at least `margin` [m] from the outline.

        With the element radius as margin: whether the element lies inside as a whole. A plane
        outline looks at x and y only.
        """

    @abstractmethod
    def of_diameter(self, diameter: float) -> "Outline":
        """The same shape, scaled to the given equivalent diameter [m]."""

    @abstractmethod
    def describe(self) -> dict:
        """What fixes the outline, for the meta of a specimen; plain JSON."""

    @property
    def equivalent_diameter(self) -> float:
        """Diameter of the circle of equal area or of the sphere of equal volume [m]."""
        if self.dimension == 2:
            return float(np.sqrt(4 * self.measure / np.pi))
        return float(np.cbrt(6 * self.measure / np.pi))


@dataclass(frozen=True)
class _Round(Outline):
    """What circle and sphere have in common. Raises GrusError unless the diameter is positive."""

    diameter: float

    def __post_init__(self) -> None:
        require_positive("diameter", self.diameter, "m")

    @property
    def bounding_radius(self) -> float:
        return self.diameter / 2

    @property
    def box(self) -> np.ndarray:
        return self.bounding_radius * np.array([[-1.0], [1.0]]) * np.ones(self.dimension)

    def contains(self, points: np.ndarray, margin: float) -> np.ndarray:
        distance = np.linalg.norm(points[:, : self.dimension], axis=1)
        return self.bounding_radius - distance >= margin

    def of_diameter(self, diameter: float) -> "Outline":
        return type(self)(diameter)

    def describe(self) -> dict:
        return {"shape": type(self).__name__.lower(), "diameter": float(self.diameter)}


class Circle(_Round):
    """Circle of the given diameter [m]."""

    dimension = 2

    @property
    def measure(self) -> float:
        return np.pi * self.diameter**2 / 4


class Sphere(_Round):
    """Sphere of the given diameter [m]."""

    dimension = 3

    @property
    def measure(self) -> float:
        return np.pi * self.diameter**3 / 6
