"""Strain that lags behind stress without any breakage, as pore water that drains: outside the library, but no stranger.

It looks like creep where only a few readings of each hold are known. What tells them apart is the course (Terzaghi & Fröhlich 1936: as
the root of time first, then to an end), the size (a share of what the stage before strained, in unloading as well), and silence.
"""

from dataclasses import dataclass
from itertools import product

import numpy as np

from grus.diagnosis.layout import Layout
from grus.diagnosis.suspect import looseness, stage_levels

SHARES = (0.02, 0.05, 0.1, 0.2, 0.4, 0.7, 0.95)
"""Of the strain of a stage and its hold, that comes late."""
TIMES = (100.0, 500.0, 2500.0, 1e4, 5e4)
"""Times H²/c [s]."""
TERMS = 20


@dataclass(frozen=True)
class Draining:
    """Delayed strain in every hold after a change of stress."""

    compared: Layout
    name: str = "unknown:draining"

    @property
    def grid(self) -> np.ndarray:
        return np.arange(len(SHARES) * len(TIMES), dtype=float)

    def change(self, size: float) -> np.ndarray:
        share, time = list(product(SHARES, TIMES))[int(size)]
        view = self.compared
        result = np.zeros(len(view.entries))
        strain = view.where(channel="strain")
        for stage, segment in enumerate(view.protocol.segments):
            own = np.flatnonzero(strain & view.where(stage=stage, kind="hold"))
            if not stage or not len(own):
                continue
            late = view.measured[own].sum()
            whole = view.measured[strain & view.where(stage=stage - 1)].sum() + late
            lasts = segment.t1 - segment.t0 if view.protocol.timed else 10 * time
            ends = [(view.entries[i].start, view.entries[i].end) for i in own]
            parts = [_drained(b * lasts / time) - _drained(a * lasts / time) for a, b in ends]
            result[own] = share * whole * np.array(parts)
        return result

    def effect(self, size: float) -> tuple[np.ndarray, np.ndarray]:
        change = self.change(size)
        return change, looseness(self.compared, change)

    def levels(self, size: float) -> np.ndarray:
        return stage_levels(self.compared, self.change(size))


def _drained(time: float) -> float:
    """Degree of consolidation [-] after a time over H²/c (Terzaghi & Fröhlich 1936)."""
    odd = (2 * np.arange(TERMS) + 1) * np.pi / 2
    return float(1 - (2 / odd**2 * np.exp(-(odd**2) * time)).sum()) if time > 0 else 0.0
