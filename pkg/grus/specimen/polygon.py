"""Polygonal outline of a plane grain."""

import numpy as np
from matplotlib.path import Path
from shapely.geometry import Polygon as ShapelyPolygon
from shapely.validation import explain_validity

from grus.specimen.outline import Outline
from grus.specimen.require import require, require_positive


class Polygon(Outline):
    """Simple polygon, convex or not.

    vertices (k, 2) [m], k >= 3, in either sense of rotation, about any origin; a vertex
    equal to the one before it, or a last one equal to the first, is dropped. They are kept
    moved to the centroid.
    Raises GrusError when they are too few, not finite, enclose no area, or when edges cross.
    """

    dimension = 2

    def __init__(self, vertices: np.ndarray) -> None:
        vertices = np.array(vertices, dtype=float)
        fits = vertices.ndim == 2 and vertices.shape[1] == 2
        require(fits, "shape of polygon vertices", vertices.shape, "(k, 2)")
        require(bool(np.isfinite(vertices).all()), "polygon vertices", "not finite", "finite")
        vertices = vertices[(vertices != np.roll(vertices, 1, axis=0)).any(axis=1)]
        require(len(vertices) >= 3, "number of polygon vertices", len(vertices), "at least 3")
        # Moved and scaled first: shapely's tests are absolute, and grains may be small or far off.
        middle, size = vertices.mean(axis=0), np.ptp(vertices, axis=0).max()
        shape = ShapelyPolygon((vertices - middle) / size)
        require(shape.area > 1e-12, "polygon area", shape.area * size**2, "> 0 m2")
        fault = explain_validity(shape).split("[")[0]
        require(shape.is_valid, "polygon", fault, "simple (no edges that cross or touch)")
        self.vertices = vertices - middle - size * np.array(shape.centroid.coords[0])
        self.vertices.flags.writeable = False
        self._measure = float(shape.area * size**2)

    @property
    def measure(self) -> float:
        return self._measure

    @property
    def bounding_radius(self) -> float:
        return float(np.linalg.norm(self.vertices, axis=1).max())

    @property
    def box(self) -> np.ndarray:
        return np.array([self.vertices.min(axis=0), self.vertices.max(axis=0)])

    def contains(self, points: np.ndarray, margin: float) -> np.ndarray:
        plane = points[:, :2]
        inside = Path(self.vertices).contains_points(plane)
        return inside & (self._edge_distance(plane) >= margin)

    def of_diameter(self, diameter: float) -> "Polygon":
        require_positive("diameter", diameter, "m")
        return Polygon(self.vertices * (diameter / self.equivalent_diameter))

    def describe(self) -> dict:
        return {"shape": "polygon", "vertices": self.vertices.tolist()}

    def _edge_distance(self, points: np.ndarray) -> np.ndarray:
        """Distance (n,) of points (n, 2) from the nearest edge."""
        start = self.vertices
        edge = np.roll(start, -1, axis=0) - start
        arm = points[:, None, :] - start
        foot = np.clip((arm * edge).sum(axis=2) / (edge**2).sum(axis=1), 0.0, 1.0)
        return np.linalg.norm(arm - foot[:, :, None] * edge, axis=2).min(axis=1)
