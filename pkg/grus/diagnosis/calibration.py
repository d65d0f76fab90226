"""Ordinary calibration: stiffness and strength of the model, found before any physics is said to be missing.

Stiffness follows from how stiff the specimen is on unloading and reloading, strength from the strain of first loading.
Stiffness needs no run of its own: in slow, small deformation strain depends on stress over strength and goes as
1/stiffness, whatever the strength.
"""

from dataclasses import dataclass

import numpy as np

from grus.diagnosis.base import STIFFNESS_BOUNDS, STRONGEST, WEAKEST, Base
from grus.diagnosis.layout import Layout
from grus.diagnosis.simulator import Simulator, Test

START = 5
"""Strength that is tried first, in steps."""
SEEDS = 2


@dataclass(frozen=True)
class Calibration:
    """base: strength as calibrated. stiffness: factor on those of the card. compared: the recording with its strains times this
    factor, as the model of stiffness 1 would have shown them. tried: strength, and simulated over recorded strain of
    first loading, of each trial; infinite where the specimen collapsed."""

    base: Base
    stiffness: float
    compared: Layout
    tried: tuple[tuple[int, float], ...]


def calibrate(measured: Layout, simulator: Simulator, seeds: tuple[int, ...]) -> Calibration:
    """Fits stiffness and strength to a recording by runs with the first seeds."""
    seeds = seeds[:SEEDS]
    elastic = _median(measured, simulator, Base(None), seeds, "calibrating stiffness")
    strain = measured.where(channel="strain")
    virgin = strain & measured.where(kind="load")
    loops = strain & (measured.where(kind="unload") | measured.where(kind="reload"))
    if elastic is None or not (virgin.any() or loops.any()):
        return Calibration(Base(START), 1.0, measured, ())
    which = loops if loops.any() else virgin
    low, high = STIFFNESS_BOUNDS
    # Unloading and reloading have opposite signs.
    recorded = max(float(np.abs(measured.measured[which]).sum()), 1e-12)
    stiffness = float(np.clip(np.abs(elastic[which]).sum() / recorded, low, high))
    compared = measured.stiffened(stiffness)
    if not virgin.any():
        return Calibration(Base(START), stiffness, compared, ())
    goal = max(float(compared.measured[virgin].sum()), 1e-9)
    tried: dict[int, float] = {}
    trial: int | None = START
    while trial is not None:
        changes = _median(measured, simulator, Base(trial), seeds, "calibrating strength")
        tried[trial] = np.inf if changes is None else float(changes[virgin].sum()) / goal
        trial = _next(tried)
    best = min(tried, key=lambda s: abs(np.log(tried[s])) if 0 < tried[s] < np.inf else np.inf)
    return Calibration(Base(best), stiffness, compared, tuple(sorted(tried.items())))


def _median(
    measured: Layout, simulator: Simulator, base: Base, seeds: tuple[int, ...], what: str
) -> np.ndarray | None:
    """Over seeds (n,); None when more than half collapsed."""
    records = simulator.run([Test(base, seed) for seed in seeds], what)
    if 2 * len(records) < len(seeds):
        return None
    return np.median([measured.of(record) for record in records.values()], axis=0)


def _next(tried: dict[int, float]) -> int | None:
    """Next strength on the way to the one that strains as the recording; None when its neighbours are known."""
    strong = [s for s, over in tried.items() if over < 1]
    weak = [s for s, over in tried.items() if over >= 1]
    if not weak:
        return min(strong) - 2 if min(strong) - 2 >= WEAKEST else None
    if not strong:
        last = sorted(weak)[-2:]
        # Where nothing breaks, nothing changes with strength.
        known = [tried[s] for s in last]
        if len(known) == 2 and np.isfinite(known).all() and np.isclose(*known, rtol=1e-3):
            return None
        return max(weak) + 2 if max(weak) + 2 <= STRONGEST else None
    between = (min(strong) + max(weak)) // 2
    return between if between not in tried else None
