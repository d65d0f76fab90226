"""Collapse on wetting as a suspect: when it happens is seen in the recording, its size is that of the DEM.

A few dozen grains collapse by one avalanche, by a larger one, or not at all, and the size has little to do with the loss
of strength. So any amount of strain may come in the jump of the recording.
"""

from dataclasses import dataclass

import numpy as np

from grus.diagnosis.creep import heard
from grus.diagnosis.fingerprint import Fingerprint
from grus.diagnosis.layout import Layout
from grus.diagnosis.suspect import Known, looseness, stage_levels

AMOUNTS = 12
LEAST, MOST = 5e-3, 10.0
"""Amounts of collapse over the strain of first loading."""


@dataclass(frozen=True)
class Collapse(Known):
    """Wetting at the time of the jump.

    broken: strain of first loading that comes from breakage [-].
    """

    fingerprint: Fingerprint
    compared: Layout
    broken: float = 0.0

    @property
    def grid(self) -> np.ndarray:
        """Strain of the collapse [-]."""
        strain = self.compared.measured[self.compared.where(channel="strain", kind="load")]
        scale = max(float(np.abs(strain).sum()), 1e-5)
        return scale * np.geomspace(LEAST, MOST, AMOUNTS)

    def change(self, size: float) -> np.ndarray:
        jump = self.compared.protocol.jump
        change = np.array(
            [
                size * (e.stage == jump.stage and (e.start, e.end) == (jump.before, jump.after))
                for e in self.compared.entries
            ]
        )
        return heard(self.compared, change * self.compared.where(channel="strain"), self.broken)

    def effect(self, size: float) -> tuple[np.ndarray, np.ndarray]:
        change = self.change(size)
        return change, looseness(self.compared, change)

    def levels(self, size: float) -> np.ndarray:
        return stage_levels(self.compared, self.change(size))

    def value(self, size: float) -> float:
        """Factor on strength at which the DEM collapses as much; linear in the logarithm of the strain."""
        ran, sizes = self._amounts()
        return float(np.interp(np.log(size), np.log(ran), sizes))

    def bracket(self, size: float) -> tuple[float, ...]:
        """The neighbouring sizes that were run: between them few specimens come to one avalanche more or less."""
        ran, sizes = self._amounts()
        above = int(np.clip(np.searchsorted(ran, size), 1, len(ran) - 1)) if len(ran) > 1 else 0
        return tuple(float(one) for one in sizes[max(above - 1, 0) : above + 1])

    def outside(self, size: float) -> bool:
        ran, _ = self._amounts()
        return not ran[0] <= size <= ran[-1]

    def _amounts(self) -> tuple[np.ndarray, np.ndarray]:
        """Strain of the collapse in the DEM at each factor, growing, and the factors."""
        hold = self.compared.where(channel="strain", stage=self.compared.protocol.jump.stage)
        ran = np.maximum(self.fingerprint.changes[:, hold].sum(axis=1), 1e-7)
        ran = np.maximum.accumulate(ran * (1 + 1e-9 * np.arange(len(ran))))
        return ran, np.array(self.fingerprint.sizes)
