"""How a curve becomes a recording: readings, noise, drift, what is left out, rounding."""

from dataclasses import asdict, dataclass

import numpy as np
import pandas as pd

from curve import Curve, readings

HEIGHT = 77.0  # of the specimen [mm]


@dataclass(frozen=True)
class Concealment:
    """What stands between the effect and who reads the recording."""

    microns: float = 1.0  # noise of a reading of the settlement [um], standard deviation
    relative: float = 0.0  # noise of a reading of the strain as a share of it [1]
    stress: float = 0.002  # noise of a reading of stress as a share of it [1]
    drift: float = 0.0  # of the strain in a day [1/d]
    labelled: bool = False  # the program is handed over with the recording
    timed: bool = True  # the recording has a time column
    ramp: int = 24  # rows of a ramp
    hold: int = 20  # rows of a hold

    def strain_noise(self, strain: np.ndarray) -> np.ndarray:
        """Standard deviation of a reading of the strain [1]."""
        return np.hypot(1e-3 * self.microns / HEIGHT, self.relative * strain)

    def to_dict(self) -> dict:
        return asdict(self)


def recording(curve: Curve, how: Concealment, rng: np.random.Generator) -> pd.DataFrame:
    """The recording as a table, headers with units."""
    read = readings(curve, how.ramp, how.hold)
    strain = read.strain + how.drift * read.time / 24
    strain = strain + how.strain_noise(read.strain) * rng.standard_normal(len(strain))
    columns = {}
    if how.timed:
        columns["time [h]"] = [f"{t:.6g}" for t in read.time]
    for name, values in {"axial_stress": read.stress, **read.others}.items():
        if name == "ae_events":
            columns[name] = np.round(values).astype(int)
            continue
        noisy = values * (1 + how.stress * rng.standard_normal(len(values)))
        columns[f"{name} [kPa]"] = [f"{v:.2f}" for v in noisy]
    columns["axial_strain [%]"] = [f"{100 * e:.5f}" for e in strain]
    return pd.DataFrame(columns)
