"""Ice powder in a die under dead loads (Furman & Goldsby)."""

from collections.abc import Callable
from pathlib import Path

import numpy as np

from grus.record import Record
from grus.recording import RecordingError

HOUR, MEGA = 3600.0, 1e6
TIME, STRAIN, DENSITY, COLUMNS = 1, 5, 7, 9

STAGES = {
    2: ((0, 33.9, 0.973), (60, 79, 1.16), (80, 100, 0.753), (125, 169.8, 0.878)),
    3: ((5, 60, 0.377), (140, 227.5, 0.251)),
    4: ((15, 38, 0.5967),),
    5: ((82, 97, 1.16), (128, 138.1, 0.44)),
    6: ((60, 90, 1.16), (91, 113, 0.47), (115, 136, 0.72), (140, 203.9, 0.59)),
    7: ((100, 170, 1.16),),
}
"""By the number of the test: hours from and to, load over area [MPa], where the authors' script calc_dens_rates.py takes
their rates. The load is in no file, and at other times it is not known. In test 4 the script gives no beginning, which
here is 15 h, where the fast settling has ended."""


def ice_powder(number: int) -> Callable[[Path], Record]:
    """What reads the file of that test."""

    def convert(path: Path) -> Record:
        table = read_columns(path)
        hours = table[:, TIME] / HOUR
        stress = np.full(len(table), np.nan)
        for start, end, load in STAGES[number]:
            stress[(hours >= start) & (hours <= end)] = MEGA * load
        known = ~np.isnan(stress)
        return Record(
            {
                "time": table[known, TIME],
                "axial_stress": stress[known],
                "axial_strain": table[known, STRAIN],
                "density": 1e3 * table[known, DENSITY],
            },
            {"time": "s", "axial_stress": "Pa", "axial_strain": "1", "density": "kg/m^3"},
            notes=(
                "axial stress: dead load over area, from the authors' script; not measured, friction not known",
                f"{int((~known).sum())} of {len(known)} readings left out: at their times no load is known",
                "between two holds the load changed once or more, at times that are not known",
                "strains from the start of the test on, of the height at that time",
                "temperature not known: 233 K or 253 K",
            ),
        )

    return convert


def read_columns(path: Path) -> np.ndarray:
    """The nine columns (n, 9): 1 is the time [s], 5 the axial strain [-], 7 the density [g/cm3]."""
    try:
        table = np.loadtxt(path, delimiter=",")
    except ValueError as error:
        raise RecordingError.of(str(path), "", str(error), "lines of nine numbers") from None
    if table.ndim != 2 or table.shape[1] != COLUMNS:
        raise RecordingError.of(str(path), "", f"shape {table.shape}", "lines of nine numbers")
    return table
