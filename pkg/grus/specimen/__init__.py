"""Specimens: agglomerates of discs or spheres as plain arrays, made from parameters and a seed."""

from grus.specimen.agglomerate import agglomerate
from grus.specimen.clump_properties import (
    ClumpProperties,
    clump_properties,
    clump_volume,
    element_volume,
)
from grus.specimen.draw import draw
from grus.specimen.join import join
from grus.specimen.mesh import Mesh
from grus.specimen.outline import Circle, Outline, Sphere
from grus.specimen.polygon import Polygon
from grus.specimen.specimen import Specimen
from grus.specimen.stamp import Stamp

__all__ = [
    "Circle",
    "ClumpProperties",
    "Mesh",
    "Outline",
    "Polygon",
    "Specimen",
    "Sphere",
    "Stamp",
    "agglomerate",
    "clump_properties",
    "clump_volume",
    "draw",
    "element_volume",
    "join",
]
