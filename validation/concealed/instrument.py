"""What the gauge of the settlement shows beside the specimen."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Instrument:
    """All off by default. Stresses [kPa], times [h], strains [1]."""

    compliance: float = 0.0  # strain of platens and frame in 100 kPa [1]
    toe: float = 0.0  # strain in which the platens come to bear [1]
    toe_stress: float = 25.0  # by which they bear for the most part
    thermal: float = 0.0  # amplitude of a daily cycle of strain [1]
    thermal_phase: float = 0.0  # [rad]
    drift: float = 0.0  # of the gauge in a day [1/d]

    def shown(self, stress: np.ndarray, time: np.ndarray) -> np.ndarray:
        """Strain (n,) that the gauge shows beside that of the specimen; zero at the first row."""
        strain = self.compliance * stress / 100
        strain = strain + self.toe * -np.expm1(-stress / self.toe_stress)
        strain = strain + self.thermal * np.sin(2 * np.pi * time / 24 + self.thermal_phase)
        strain = strain + self.drift * time / 24
        return strain - strain[0]
