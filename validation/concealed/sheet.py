"""A sheet of all recordings of a folder, to be looked at: python3 sheet.py trials/development sheet.png"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

COLUMNS = 6  # trials in a row


def sheet(folder: Path, path: Path) -> None:
    """Strain against stress, and against the clock or the row, of each trial."""
    files = sorted(folder.glob("*/recording.csv"))
    rows = -(-len(files) // COLUMNS)
    figure, axes = plt.subplots(2 * rows, COLUMNS, figsize=(3 * COLUMNS, 4.6 * rows), squeeze=False)
    for axis in axes.flat:
        axis.set_visible(False)
    for number, file in enumerate(files):
        table = pd.read_csv(file)
        strain = table["axial_strain [%]"]
        row, column = divmod(number, COLUMNS)
        clock = table["time [h]"] if "time [h]" in table else np.arange(len(table))
        above, below = axes[2 * row, column], axes[2 * row + 1, column]
        above.plot(table["axial_stress [kPa]"], strain, "k.-", ms=1.5, lw=0.4)
        if "base_stress [kPa]" in table:
            above.plot(table["base_stress [kPa]"], strain, "b-", lw=0.5)
        below.plot(clock, strain, "k.-", ms=1.5, lw=0.4)
        if "ae_events" in table:
            other = below.twinx()
            other.plot(clock, table["ae_events"], "r-", lw=0.5)
            other.tick_params(labelsize=5)
        above.set_title(f"{file.parent.name}  kPa, %", fontsize=8)
        below.set_title("h" if "time [h]" in table else "rows", fontsize=7)
        for axis in (above, below):
            axis.set_visible(True)
            axis.invert_yaxis()
            axis.tick_params(labelsize=6)
    figure.tight_layout(pad=0.3)
    figure.savefig(path, dpi=70)


if __name__ == "__main__":
    sheet(Path(sys.argv[1]), Path(sys.argv[2]))
