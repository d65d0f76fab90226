"""Triangle surfaces read from STL and GTS files."""

from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOGeometry import vtkSTLReader

from grus.errors import GrusError
from grus.specimen.require import require


def read_surface(path: str | Path) -> tuple[np.ndarray, np.ndarray]:
    """Vertices (k, 3) in the units of the file and triangles (t, 3) of vertex indices.

    The ending of the name tells the format: .stl (text or binary) or .gts.
    Raises FileNotFoundError, or GrusError when the ending is another or the content is broken.
    """
    path = Path(path)
    if not path.is_file():
        raise FileNotFoundError(f"mesh file = {path}: does not exist")
    readers = {".stl": _read_stl, ".gts": _read_gts}
    require(path.suffix.lower() in readers, "mesh file", path, "a .stl or .gts file")
    vertices, triangles = readers[path.suffix.lower()](path)
    require(len(triangles) > 0, "mesh file", path, "a readable surface with triangles")
    return vertices, triangles


def _read_stl(path: Path) -> tuple[np.ndarray, np.ndarray]:
    reader = vtkSTLReader()
    reader.AddObserver("ErrorEvent", lambda *_: None)  # The caller raises; VTK would print.
    reader.SetFileName(str(path))
    reader.Update()
    surface = reader.GetOutput()
    if surface.GetNumberOfPolys() == 0:
        return np.empty((0, 3)), np.empty((0, 3), dtype=np.int64)
    vertices = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return vertices, triangles.astype(np.int64)


def _read_gts(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """GTS lists vertices, edges as pairs of vertices, and faces as triples of edges, from 1."""
    lines = (line.split("#")[0].split("!")[0].split() for line in path.read_text().splitlines())
    rows = [line for line in lines if line]
    try:
        vertex_count, edge_count, face_count = (int(word) for word in rows[0][:3])
        ends = np.cumsum([1, vertex_count, edge_count, face_count])
        vertices = np.array([row[:3] for row in rows[ends[0] : ends[1]]], dtype=float)
        edges = np.array([row[:2] for row in rows[ends[1] : ends[2]]], dtype=np.int64) - 1
        faces = np.array([row[:3] for row in rows[ends[2] : ends[3]]], dtype=np.int64) - 1
        if (len(vertices), len(edges), len(faces)) != (vertex_count, edge_count, face_count):
            raise ValueError("it ends before what its first line announces")
        if edges.min() < 0 or faces.min() < 0 or edges.max() >= vertex_count:
            raise ValueError("an index is out of range")
        base, next_edge = edges[faces[:, 0]], edges[faces[:, 1]]
    except (ValueError, IndexError) as error:
        raise GrusError(f"mesh file = {path}: must be a GTS surface ({error})") from None
    # An edge gives two corners in any order; the third is the end of the next that is not one.
    shared = (next_edge[:, :1] == base).any(axis=1)
    return vertices, np.column_stack([base, np.where(shared, next_edge[:, 1], next_edge[:, 0])])
