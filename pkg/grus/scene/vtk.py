"""Elements and bonds as a VTK file for ParaView."""

from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from grus.files import replacing
from grus.scene.snapshot import Snapshot
from grus.specimen import Specimen


def write_vtk(path: str | Path, specimen: Specimen, state: Snapshot) -> Path:
    """Writes a .vtp file: a point an element, a line a bond that holds. Returns the path.

    Point data: radius [m] (scale sphere glyphs by it), clump, grain, fragment, velocity [m/s].
    """
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(state.position), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetVerts(_cells(np.arange(specimen.element_count)[:, None]))
    data.SetLines(_cells(state.bonds))
    fields = {
        "radius": specimen.radius,
        "clump": specimen.clump,
        "grain": specimen.grain,
        "fragment": state.fragment,
        "velocity": state.velocity,
    }
    for name, values in fields.items():
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    with replacing(path) as partial:
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(str(partial))
        writer.SetInputData(data)
        if not writer.Write():
            raise OSError(f"{path}: cannot be written")
    return Path(path)


def _cells(points: np.ndarray) -> vtkCellArray:
    """Cells of equal size from point indices (cells, points a cell)."""
    cells = vtkCellArray()
    for cell in points.tolist():
        cells.InsertNextCell(len(cell))
        for point in cell:
            cells.InsertCellPoint(point)
    return cells
