"""Cells: the parts of a stage between which a recording and a simulation are compared.

A stage is cut at a few stresses (loading, unloading) or at times that grow by a factor (hold). What is compared is the
change of strain over each cell. Levels of strain say little, since small specimens scatter; changes within a stage say
much. Knots are fitted to all readings of the stage, and to a simulation that was read at the same readings, by the same
matrix, so that fitting adds no difference.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from grus.diagnosis.jump import Jump, noise_of_strain, places
from grus.record import Record, Segment

RAMP_CELLS = 4
HOLD_TIMES = (0.0, 0.003, 0.01, 0.03, 0.1, 0.25, 0.5, 0.75, 1.0)
"""Knots of a hold as shares of its time: near decades first, evenly later, so that a step within it shows."""
FEWEST = 3
"""Readings that a cell has, at least."""
CLEARLY = 4.0
"""Variance of the readings of a cell over that of the stage, from which it counts."""


@dataclass(frozen=True)
class Cells:
    """Cells of one stage.

    stage: number in the protocol. kind: of its segment. rows: readings of the recording, in their order. at: place of
    each reading (n,), stress [Pa] or, in a hold, share of its time. knots (m+1,): ends of the cells, likewise.
    changes (m, n): matrix that makes the changes of strain over the cells out of the strains of the readings.
    noise (m, m): covariance of these changes by the noise of the readings.
    """

    stage: int
    kind: str
    rows: np.ndarray
    at: np.ndarray
    knots: np.ndarray
    changes: np.ndarray
    noise: np.ndarray

    def __len__(self) -> int:
        return len(self.knots) - 1


def cells(
    record: Record, segment: Segment, stage: int, lowest: float, jump: Jump | None = None
) -> Cells | None:
    """Cells of a segment of a recording; None when it has too few readings above `lowest` [Pa].

    jump: of strain in this hold, which is a cell of its own.
    """
    rows = np.arange(segment.first, segment.last + 1)
    strain = record["axial_strain"][rows]
    rows = rows[np.isfinite(strain)]
    sigma = noise_of_strain(segment)
    ends: tuple[float, ...] = ()
    if segment.kind == "hold":
        at = places(record, segment, rows)
        wanted = np.asarray(HOLD_TIMES if "time" in record.channels else (0.0, 1.0))
        if jump is not None:
            ends = (jump.before, jump.after)
            outside = wanted[(wanted < jump.before) | (wanted > jump.after)]
            wanted = np.unique([*outside, *ends])
    else:
        low, high = sorted((segment.stress_from, segment.stress_to))
        at = np.clip(record["axial_stress"][rows], low, high)
        keep = at >= min(lowest, high)
        rows, at = rows[keep], at[keep]
        low = max(low, lowest)
        spread = np.geomspace if high > 4 * low > 0 else np.linspace
        wanted = spread(low, high, RAMP_CELLS + 1)
        if segment.stress_to < segment.stress_from:
            wanted = wanted[::-1]
    if len(rows) < 2 or np.ptp(at) <= 0:
        return None
    knots = _filled(wanted, at, ends)
    hats = _hats(at, knots)
    # A weak pull to straight lines, for cells whose readings lie at one end.
    bend = np.diff(np.eye(len(knots)), 2, axis=0) * 1e-3 if len(knots) > 2 else np.zeros((0, 2))
    fit = np.linalg.pinv(np.vstack([hats, bend]))[:, : len(at)]
    changes = np.diff(np.eye(len(knots)), axis=0) @ fit
    rest = record["axial_strain"][rows] - hats @ (fit @ record["axial_strain"][rows])
    variances = _variances(rest, at, knots, sigma)
    return Cells(stage, segment.kind, rows, at, knots, changes, (changes * variances) @ changes.T)


def _variances(rest: np.ndarray, at: np.ndarray, knots: np.ndarray, sigma: float) -> np.ndarray:
    """Of each reading (n,): sigma squared, or what the readings of its cell are off the fit where that is clearly more."""
    cell = np.searchsorted(np.sort(knots)[1:-1], at)
    squares = np.bincount(cell, rest**2, len(knots) - 1)
    # Each cell takes about one number of its readings.
    freedom = np.maximum(np.bincount(cell, minlength=len(knots) - 1) - 1, 1)
    found = (squares / freedom)[cell]
    return np.where(found > CLEARLY * sigma**2, found, sigma**2)


def _filled(wanted: np.ndarray, at: np.ndarray, needed: Sequence[float]) -> np.ndarray:
    """The knots between which there are readings enough, the first, the last and those needed among them."""
    kept = [wanted[0]]
    for knot in wanted[1:-1]:
        following = min((one for one in needed if one > knot), default=wanted[-1])
        between = np.count_nonzero((at - kept[-1]) * (knot - at) >= 0)
        after = np.count_nonzero((at - knot) * (following - at) >= 0)
        if knot in needed or (between >= FEWEST and after >= FEWEST):
            kept.append(knot)
    return np.array([*kept, wanted[-1]])


def _hats(at: np.ndarray, knots: np.ndarray) -> np.ndarray:
    """Piecewise linear functions (n, m+1) that are 1 at one knot and 0 at the others."""
    order = np.argsort(knots)
    return np.stack(
        [np.interp(at, knots[order], np.eye(len(knots))[k][order]) for k in range(len(knots))], 1
    )
