"""Glass beads in an oedometer, as the GrainLearning repository keeps them."""

from pathlib import Path

import numpy as np

from grus.record import Record
from grus.recording import RecordingError

MEGA = 1e6
COLUMNS = 4


def glass_beads(path: Path) -> Record:
    """Columns e_a [-], p [MPa], q [MPa] and porosity [-], without times; loaded, unloaded, loaded again, unloaded."""
    try:
        table = np.loadtxt(path)
    except ValueError as error:
        raise RecordingError.of(str(path), "", str(error), "lines of four numbers") from None
    if table.ndim != 2 or table.shape[1] != COLUMNS:
        raise RecordingError.of(str(path), "", f"shape {table.shape}", "lines of four numbers")
    strain, mean, deviator, porosity = table.T
    return Record(
        {
            "axial_stress": MEGA * (mean + 2 * deviator / 3),
            "axial_strain": strain,
            "lateral_stress": MEGA * (mean - deviator / 3),
            "porosity": porosity,
        },
        {"axial_stress": "Pa", "axial_strain": "1", "lateral_stress": "Pa", "porosity": "1"},
        notes=(
            "axial stress p + 2q/3, lateral stress p - q/3",
            "strains from the first reading on, which is at 6.8 MPa",
        ),
    )
