"""The oedometer around the specimen: what stands between the stress that is recorded and the one that acts."""

from dataclasses import dataclass

import numpy as np
from scipy.linalg import solve_banded

from instrument import Instrument

HEIGHT_OVER_WIDTH = 0.95
NODES = 21


@dataclass(frozen=True)
class Apparatus(Instrument):
    """All off by default. Stresses [kPa], times [h], strains [1]."""

    wall_friction: float = 0.0  # coefficient of friction times lateral over axial stress [1]
    mobilised: float = 2e-4  # settlement over height that mobilises the friction of a wall [1]
    overstress: float = 0.0  # of platens that move too fast: density x wave speed x platen speed
    drainage_time: float = 0.0  # of pore water: (half height)^2 / coefficient of consolidation
    leak: float = 0.0  # share of the load that a hold loses, unseen by the gauge [1]
    leak_time: float = 20.0


class PoreWater:
    """Excess pressure between two drained platens (Terzaghi 1943), by implicit differences."""

    def __init__(self, drainage_time: float):
        self.drainage_time = drainage_time
        self.pressure = np.zeros(NODES)

    def advance(self, load: float, hours: float) -> float:
        """Mean excess pressure [kPa] after `hours` in which the stress rose by `load` [kPa]."""
        self.pressure[1:-1] += load
        ratio = hours / self.drainage_time * ((NODES - 1) / 2) ** 2
        bands = np.zeros((3, NODES))
        bands[1] = 1
        bands[1, 1:-1] += 2 * ratio
        bands[0, 2:] = bands[2, :-2] = -ratio
        self.pressure = solve_banded((1, 1), bands, self.pressure)
        return float(self.pressure.mean())


class Walls:
    """Friction of the side walls of a fixed ring, after Janssen (1895) and Terzaghi (1943), mobilised by settlement."""

    def __init__(self, apparatus: Apparatus, layers: int):
        # The share of its stress that a layer hands to two walls, fully mobilised.
        self.share = 2 * apparatus.wall_friction * HEIGHT_OVER_WIDTH / layers
        self.mobilised = apparatus.mobilised
        self.state = np.zeros(layers)
        self._settled = np.zeros(layers)

    def stresses(self, top: float, strains: np.ndarray) -> tuple[np.ndarray, float]:
        """Axial stresses in the middle of the layers (n,) from the top down, and on the base [kPa]."""
        n = len(strains)
        # Settlement of each layer's middle over the height of the specimen.
        settled = (np.cumsum(strains[::-1])[::-1] - 0.5 * strains) / n
        self.state = np.clip(self.state + (settled - self._settled) / self.mobilised, -1, 1)
        self._settled = settled
        handed = np.exp(-self.share * self.state)
        below = top * np.cumprod(handed)
        middle = below / np.sqrt(handed)
        return middle, float(below[-1])
