"""Collapse on wetting as a suspect: when it happens is seen in the recording, its size is that of the DEM.

A few dozen grains collapse by one avalanche, by a larger one, or not at all, and the size has little to do with the loss
of strength. So any amount of strain may come in the jump of the recording.
"""

from dataclasses import dataclass

import numpy as np

from grus.diagnosis.avalanche import Avalanche
from grus.diagnosis.suspect import looseness

AMOUNTS = 12
LEAST, MOST = 5e-3, 10.0
"""Amounts of collapse over the strain of first loading."""


@dataclass(frozen=True)
class Collapse(Avalanche):
    """Wetting at the time of the jump."""

    @property
    def grid(self) -> np.ndarray:
        """Strain of the collapse [-]."""
        return self.first_loading() * np.geomspace(LEAST, MOST, AMOUNTS)

    def amount(self, size: float) -> float:
        return size

    def change(self, size: float) -> np.ndarray:
        jump = self.compared.protocol.jump
        change = np.array(
            [
                size * (e.stage == jump.stage and (e.start, e.end) == (jump.before, jump.after))
                for e in self.compared.entries
            ]
        )
        return self.heard(change * self.compared.where(channel="strain"))

    def acts(self) -> np.ndarray:
        return self.compared.where(channel="strain", stage=self.compared.protocol.jump.stage)

    def effect(self, size: float) -> tuple[np.ndarray, np.ndarray]:
        change = self.change(size)
        return change, looseness(self.compared, change)

    def value(self, size: float) -> float:
        """Factor on strength at which the DEM collapses as much; linear in the logarithm of the strain."""
        ran, sizes = self.amounts()
        return float(np.interp(np.log(size), np.log(ran), sizes))
