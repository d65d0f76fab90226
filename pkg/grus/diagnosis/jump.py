"""The largest jump of strain at constant stress in a recording: when a specimen may have collapsed.

Readings of a hold are often many at its beginning and few at its end, so that a jump lies between two or three of them.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from grus.record import Record, Segment

AROUND = 3
"""Readings at the ends of a hold of which the mean counts."""
FEWEST = 8
"""Readings that a hold has, at least."""
EARLY = 0.003
"""Share of a hold from which creep goes with the logarithm of time."""
SETTLED = 0.02
"""Share of a hold before which nothing counts as a jump."""
CLEAR = 6.0
"""Least jump over its standard error."""
MOST_OF_IT = 0.5
"""Least jump over all that the hold adds from then on."""
MOST = 400
"""Readings of a hold that are looked at; where there are more, means of neighbours."""
FLOOR = 2e-6
"""Strain [-] below which no reading is believed."""


@dataclass(frozen=True)
class Jump:
    """stage: number in the protocol. before, after: shares of the time of the hold between which it lies, of the readings of
    a recording without times. strain: its size [-]."""

    stage: int
    before: float
    after: float
    strain: float


def largest_jump(record: Record, followed: Sequence[Segment]) -> Jump | None:
    """Of the segments that a protocol follows; None when no hold has a clear one."""
    found = [_of_hold(record, s, n) for n, s in enumerate(followed) if s.kind == "hold"]
    return max((j for j in found if j is not None), key=lambda j: j.strain, default=None)


def _of_hold(record: Record, segment: Segment, stage: int) -> Jump | None:
    rows = np.arange(segment.first, segment.last + 1)
    rows = rows[np.isfinite(record["axial_strain"][rows])]
    at, strain = places(record, segment, rows), record["axial_strain"][rows]
    if len(rows) > MOST:
        at, strain = (
            np.array([part.mean() for part in np.array_split(x, MOST)]) for x in (at, strain)
        )
    # What creeps or drifts: a jump is what neither can be.
    smooth = np.column_stack([np.ones(len(at)), at, np.log(at + EARLY)])
    best: Jump | None = None
    for last in range(1, len(at) - 2):
        for first in (last + 1, last + 2):
            if at[last] < SETTLED or first + 2 > len(at):
                continue
            kept = np.r_[: last + 1, first : len(at)]
            design = np.column_stack([smooth, np.arange(len(at)) >= first])[kept]
            if len(kept) < FEWEST:
                continue
            found, _, rank, _ = np.linalg.lstsq(design, strain[kept], None)
            if rank < design.shape[1]:
                continue
            freedom = len(kept) - design.shape[1]
            sigma = max(
                noise_of_strain(segment),
                float(np.linalg.norm(strain[kept] - design @ found)) / np.sqrt(freedom),
            )
            error = sigma * np.sqrt(np.linalg.inv(design.T @ design)[-1, -1])
            whole = strain[-AROUND:].mean() - strain[at >= SETTLED][:AROUND].mean()
            step = float(found[-1])
            if step > max(CLEAR * error, MOST_OF_IT * whole) and (
                best is None or step > 1.02 * best.strain
            ):
                best = Jump(stage, float(at[last]), float(at[first]), step)
    return best


def noise_of_strain(segment: Segment) -> float:
    """Standard deviation [-] of a reading."""
    return max(segment.noise.get("axial_strain", 0.0), FLOOR)


def places(record: Record, segment: Segment, rows: np.ndarray) -> np.ndarray:
    """Places (n,) of the readings of a hold: shares of its time, or of its readings in a recording without times."""
    if "time" not in record.channels:
        return (rows - segment.first) / max(segment.last - segment.first, 1)
    return (record["time"][rows] - segment.t0) / (segment.t1 - segment.t0)
