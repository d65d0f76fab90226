"""Outline of a plane grain, given by its vertices."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from shapely.geometry import Polygon

from grus.card.errors import Problem
from grus.card.values import finite

MOST_VERTICES = 1000
LARGEST_COORDINATE = 1e6
THINNEST = 1e-4  # area over the square of the largest extent


@dataclass(frozen=True)
class Vertices:
    """A simple polygon: list of [x, y], in either sense of turning."""

    allowed: str = (
        f"a list of 3 to {MOST_VERTICES} points [x, y], coordinates within "
        f"+-{LARGEST_COORDINATE:.0f}, no sides that cross"
    )

    def read(self, value: Any) -> tuple[tuple[float, float], ...]:
        if not isinstance(value, (list, tuple)):
            raise Problem("not a list of points", self.allowed)
        if not 3 <= len(value) <= MOST_VERTICES:
            raise Problem("too few or too many vertices", self.allowed)
        points = tuple(self._point(i, point) for i, point in enumerate(value, start=1))
        if not _is_simple(np.array(points)):
            raise Problem("not a polygon: sides cross or touch, or there is no area", self.allowed)
        return points

    def _point(self, number: int, point: Any) -> tuple[float, float]:
        if not isinstance(point, (list, tuple)) or len(point) != 2:
            raise Problem(f"vertex {number} is not a pair [x, y]", self.allowed)
        try:
            x, y = (finite(coordinate, self.allowed) for coordinate in point)
        except Problem as problem:
            raise Problem(
                f"a coordinate of vertex {number} is {problem.reason}", self.allowed
            ) from None
        if max(abs(x), abs(y)) > LARGEST_COORDINATE:
            raise Problem(f"vertex {number} is too far out", self.allowed)
        return x, y


def _is_simple(points: np.ndarray) -> bool:
    """Whether the sides neither cross nor touch and the area is not next to nothing."""
    extent = np.ptp(points, axis=0).max()
    if extent == 0:
        return False
    shape = Polygon((points - points.mean(axis=0)) / extent)
    return bool(shape.is_valid and shape.area > THINNEST)
