"""Outline given by a closed surface of triangles."""

import hashlib
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import (
    vtkCleanPolyData,
    vtkFeatureEdges,
    vtkImplicitPolyDataDistance,
    vtkPolyDataNormals,
)

from grus.specimen.outline import Outline
from grus.specimen.require import require, require_positive
from grus.specimen.surface_file import read_surface

COINCIDENT = 1e-7
"""Vertices nearer than this share of the mesh's size are one; STL repeats them, rounded."""


class Mesh(Outline):
    """Closed surface of triangles, convex or not.

    vertices (k, 3) [m] about any origin; triangles (t, 3) of vertex indices, facing either way.
    Kept in that form with coincident vertices joined, the volume centroid at the origin and the
    triangles counter-clockwise seen from outside. Whether the surface cuts through itself is not
    examined. Inside and distance come from VTK (angle-weighted normals, Baerentzen & Aanaes 2005).
    Raises GrusError when shapes or indices are wrong, when an edge does not belong to exactly
    two triangles (the surface is open or branches), or when it encloses no volume.
    """

    dimension = 3

    def __init__(self, vertices: np.ndarray, triangles: np.ndarray) -> None:
        vertices, triangles = np.array(vertices, dtype=float), np.array(triangles, dtype=np.int64)
        for key, array in {"vertices": vertices, "triangles": triangles}.items():
            fits = array.ndim == 2 and array.shape[1] == 3 and len(array) > 0
            require(fits, f"shape of mesh {key}", array.shape, "(k, 3)")
        require(bool(np.isfinite(vertices).all()), "mesh vertices", "not finite", "finite")
        in_range = triangles.min() >= 0 and triangles.max() < len(vertices)
        require(bool(in_range), "mesh triangles", "out of range", f"0..{len(vertices) - 1}")

        middle, size = vertices.mean(axis=0), np.ptp(vertices, axis=0).max()
        require_positive("size of the mesh", size, "m")
        unit, triangles = _closed_and_oriented((vertices - middle) / size, triangles)
        volume, centroid = _volume_and_centroid(unit, triangles)
        if volume < 0:
            volume, triangles = -volume, triangles[:, ::-1]
        require(volume > 1e-12, "mesh volume", volume * size**3, "> 0 m3")
        self.vertices, self.triangles = size * (unit - centroid), triangles
        self._measure = float(volume * size**3)

    @classmethod
    def read(cls, path: str | Path, unit: float = 1.0) -> "Mesh":
        """Mesh from an STL or GTS file whose lengths are in `unit` [m].

        Raises FileNotFoundError; GrusError for another format or a surface that is not closed.
        """
        require_positive("unit", unit, "m")
        vertices, triangles = read_surface(path)
        return cls(vertices * unit, triangles)

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
        # In units of the mesh's size, because VTK's tolerances are absolute.
        size = self.bounding_radius
        signed = vtkImplicitPolyDataDistance()
        signed.SetInput(_to_vtk(self.vertices / size, self.triangles))
        distance = vtkDoubleArray()
        signed.FunctionValue(numpy_to_vtk(np.ascontiguousarray(points / size)), distance)
        return -size * vtk_to_numpy(distance) >= margin

    def of_diameter(self, diameter: float) -> "Mesh":
        require_positive("diameter", diameter, "m")
        return Mesh(self.vertices * (diameter / self.equivalent_diameter), self.triangles)

    def describe(self) -> dict:
        content = self.vertices.astype("<f8").tobytes() + self.triangles.astype("<i8").tobytes()
        return {
            "shape": "mesh",
            "triangles": len(self.triangles),
            "volume": self.measure,
            "sha256": hashlib.sha256(content).hexdigest(),
        }


def _to_vtk(vertices: np.ndarray, triangles: np.ndarray) -> vtkPolyData:
    points, cells, surface = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(vertices), deep=True))
    starts = np.arange(0, triangles.size + 1, 3)
    cells.SetData(
        numpy_to_vtkIdTypeArray(starts, deep=True),
        numpy_to_vtkIdTypeArray(np.ascontiguousarray(triangles).ravel(), deep=True),
    )
    surface.SetPoints(points)
    surface.SetPolys(cells)
    return surface


def _closed_and_oriented(
    vertices: np.ndarray, triangles: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    clean = vtkCleanPolyData()
    clean.SetInputData(_to_vtk(vertices, triangles))
    clean.ToleranceIsAbsoluteOn()
    clean.SetAbsoluteTolerance(COINCIDENT)
    clean.ConvertPolysToLinesOff()
    clean.ConvertLinesToPointsOff()
    edges = vtkFeatureEdges()
    edges.SetInputConnection(clean.GetOutputPort())
    edges.FeatureEdgesOff()
    edges.BoundaryEdgesOn()
    edges.NonManifoldEdgesOn()
    edges.Update()
    faulty = edges.GetOutput().GetNumberOfLines()
    require(faulty == 0, "mesh edges without exactly two triangles", faulty, "0")

    normals = vtkPolyDataNormals()
    normals.SetInputConnection(clean.GetOutputPort())
    normals.ConsistencyOn()
    normals.AutoOrientNormalsOn()
    normals.SplittingOff()
    normals.Update()
    surface = normals.GetOutput()
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return vtk_to_numpy(surface.GetPoints().GetData()).astype(float), corners.astype(np.int64)


def _volume_and_centroid(vertices: np.ndarray, triangles: np.ndarray) -> tuple[float, np.ndarray]:
    """Sums over the tetrahedra between the origin and each triangle (divergence theorem)."""
    corners = vertices[triangles]
    volume = np.linalg.det(corners) / 6
    total = volume.sum()
    if total == 0:
        return 0.0, np.zeros(3)
    return total, (volume[:, None] * corners.sum(axis=1) / 4).sum(axis=0) / total
