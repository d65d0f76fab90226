"""Static fatigue of bonds as a suspect: the time course is the law's own, its size is that of the DEM.

A few dozen grains give a few delayed failures, in steps of very unequal height, where a laboratory specimen of many
grains gives a smooth curve. What both have in common follows from the law. A bond under stress s fails after a time that goes as
s^-n, and bonds carry stresses of many sizes; so failures are spread evenly over the logarithm of time, and what a hold
adds is the logarithm of how much the used-up life has grown, life under a smaller stress counting little: with n of
some tens, nothing goes on after unloading, and a second hold at the same stress goes on where the first ended.
"""

from dataclasses import dataclass
from itertools import product

import numpy as np

from grus.diagnosis.avalanche import Avalanche
from grus.diagnosis.layout import Layout
from grus.diagnosis.protocol import LOWEST
from grus.diagnosis.suspect import looseness

EXPONENT = 20.0
"""Of used-up life with stress; what comes out hardly depends on it above 10."""
TIMES = (60.0, 600.0, 3600.0)
"""Times [s] from which on strain goes with the logarithm of time."""
POWERS = (0.75, 1.5, 2.2, 3.0, 6.0)
"""Exponents of creep with stress."""
AMOUNTS = 16
LEAST, MOST = 2e-3, 60.0
"""Amounts of creep over the strain of first loading."""
UNEVEN = 0.25
"""Scatter of creep from cell to cell, as a share."""
RENEWED = 0.3
"""Scatter of what a hold adds under a stress that was held before, over what it would add for the first time: unloading
and reloading find other paths for the load."""
STEPS = (0.03, 0.3)
"""Shares of the creep of all holds that come in one step, by chance in one cell or in the next: delayed failures come in
avalanches, many in a large specimen and few in a small or brittle one."""
SILENT = 0.1
"""Share of all acoustic events that a hold may have more or less than goes with its strain: some bonds fail and move nothing."""


@dataclass(frozen=True)
class Creep(Avalanche):
    """Bond ageing, with amounts of creep in all holds together, and courses with time and stress."""

    @property
    def cases(self) -> list[tuple[float, float, float, float]]:
        """Amount of strain in all holds, time from which it grows [s], exponent with stress, share of a step."""
        amounts = self.first_loading() * np.geomspace(LEAST, MOST, AMOUNTS)
        # A grid that is thinned shows all amounts first.
        return list(product(amounts, TIMES, POWERS, STEPS))

    @property
    def grid(self) -> np.ndarray:
        return np.arange(len(self.cases), dtype=float)

    def amount(self, size: float) -> float:
        return self.cases[int(size)][0]

    def change(self, size: float) -> np.ndarray:
        amount, time, power, _ = self.cases[int(size)]
        return self.heard(amount * course(self.compared, time, power))

    def acts(self) -> np.ndarray:
        return self.compared.where(channel="strain", kind="hold")

    def effect(self, size: float) -> tuple[np.ndarray, np.ndarray]:
        change = self.change(size)
        amount, time, power, step = self.cases[int(size)]
        strain = self.compared.where(channel="strain")
        heard = self.compared.where(channel="events")
        steps = np.where(strain, step * amount * change, 0.0) + np.where(heard, SILENT**2, 0.0)
        spread = looseness(self.compared, change, shape=UNEVEN) + np.diag(steps)
        again = RENEWED * amount * renewed(self.compared, time, power)
        for stage in {e.stage for e in self.compared.entries}:
            own = np.where(self.compared.where(stage=stage), again, 0.0)
            spread += np.outer(own, own)
        return change, spread

    def value(self, size: float) -> float:
        """Reference time [s] at which the DEM creeps by the same amount in all holds; linear in the logarithms."""
        ran, sizes = self.amounts()
        return float(np.exp(np.interp(np.log(self.amount(size)), np.log(ran), np.log(sizes))))


def course(compared: Layout, time: float, power: float) -> np.ndarray:
    """Share (n,) of the creep of all holds that comes in each cell."""
    result = _by_law(compared, time, power, memory=True)
    return result / max(result.sum(), 1e-12)


def renewed(compared: Layout, time: float, power: float) -> np.ndarray:
    """What holds would add (n,) beyond `course`, over the creep of all holds, if what was held before did not count."""
    law = _by_law(compared, time, power, memory=True)
    highest = 0.0
    fresh = _by_law(compared, time, power, memory=False)
    for stage, segment in enumerate(compared.protocol.segments):
        if segment.stress_to < 0.97 * highest:
            fresh = np.where(compared.where(stage=stage), law, fresh)
        highest = max(highest, segment.stress_to)
    return np.maximum(fresh - law, 0.0) / max(law.sum(), 1e-12)


def _by_law(compared: Layout, time: float, power: float, memory: bool) -> np.ndarray:
    """Creep (n,) in some unit; memory: whether life that was used up before counts."""
    result = np.zeros(len(compared.entries))
    segments = compared.protocol.segments
    highest = compared.protocol.highest
    for stage, segment in enumerate(segments):
        own = np.flatnonzero(compared.where(stage=stage, kind="hold", channel="strain"))
        if not len(own):
            continue
        stress = max(segment.stress_to, LOWEST * highest)
        level = (stress / highest) ** power
        if not compared.protocol.timed:
            held = (s.stress_to for s in segments[:stage])
            before = max(held, default=0.0) if memory else 0.0
            result[own] = level * (segment.stress_to >= 0.97 * before) / len(own)
            continue
        used = time
        if memory:
            used += sum(
                (s.t1 - s.t0) * (max(s.stress_from, s.stress_to) / stress) ** EXPONENT
                for s in segments[:stage]
                if s.kind == "hold"
            )
        lasts = segment.t1 - segment.t0
        ends = [(compared.entries[i].start, compared.entries[i].end) for i in own]
        result[own] = [level * np.log((used + b * lasts) / (used + a * lasts)) for a, b in ends]
    return result
