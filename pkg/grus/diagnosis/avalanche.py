"""What mechanisms have in common that make bonds break under constant stress: any amount of strain, of which the DEM tells the size.

A few dozen grains give one avalanche, another, or none: their strain is no measure of the recording's, only of which size
of the mechanism gives about as much.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from grus.diagnosis.fingerprint import Fingerprint
from grus.diagnosis.layout import Layout
from grus.diagnosis.suspect import Known, stage_levels


@dataclass(frozen=True)
class Avalanche(Known, ABC):
    """A mechanism in holds.

    broken: strain of first loading that comes from breakage [-]; acoustic events go with it as with what holds add.
    """

    fingerprint: Fingerprint
    compared: Layout
    broken: float = 0.0

    @abstractmethod
    def amount(self, size: float) -> float:
        """Strain in all holds [-] at a size of the grid."""

    @abstractmethod
    def change(self, size: float) -> np.ndarray:
        """Mean change (n,) at a size of the grid."""

    @abstractmethod
    def acts(self) -> np.ndarray:
        """Entries (n,) whose strains in the DEM are its amount."""

    def levels(self, size: float) -> np.ndarray:
        return stage_levels(self.compared, self.change(size))

    def of_fingerprint(self, size: float) -> float:
        """Effect of the fingerprint whose runs strain as much; no more than those of the strongest, no less than none."""
        ran, _ = self.amounts()
        amount = self.amount(size)
        if amount < ran[0]:
            return amount / ran[0]
        return float(np.interp(np.log(amount), np.log(ran), np.arange(1, len(ran) + 1)))

    def bracket(self, size: float) -> tuple[float, ...]:
        """The neighbouring sizes that were run: between them few specimens come to one avalanche more or less."""
        ran, sizes = self.amounts()
        if len(ran) == 1:
            return (float(sizes[0]),)
        above = int(np.clip(np.searchsorted(ran, self.amount(size)), 1, len(ran) - 1))
        return float(sizes[above - 1]), float(sizes[above])

    def outside(self, size: float) -> bool:
        ran, _ = self.amounts()
        return not ran[0] <= self.amount(size) <= ran[-1]

    def amounts(self) -> tuple[np.ndarray, np.ndarray]:
        """Strain (g,) of the DEM at each size that was run, growing, and the sizes (g,)."""
        ran = np.maximum(self.fingerprint.changes[:, self.acts()].sum(axis=1), 1e-7)
        ran = np.maximum.accumulate(ran * (1 + 1e-9 * np.arange(len(ran))))
        return ran, np.array(self.fingerprint.sizes)

    def first_loading(self) -> float:
        """Strain [-] of all first loading of the recording, the scale of amounts."""
        strain = self.compared.measured[self.compared.where(channel="strain", kind="load")]
        return max(float(np.abs(strain).sum()), 1e-5)

    def heard(self, change: np.ndarray) -> np.ndarray:
        """The change (n,) of strain in holds with the share of acoustic events that goes with it."""
        result = change.copy()
        strain = self.compared.where(channel="strain")
        whole = change[strain].sum() + max(self.broken, 0.0)
        for entry in np.flatnonzero(self.compared.where(channel="events")):
            own = strain & self.compared.where(stage=self.compared.entries[entry].stage)
            result[entry] = change[own].sum() / max(whole, 1e-12)
        return result
