"""What happened to a specimen, and what is read of it."""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace

import numpy as np


@dataclass(frozen=True)
class Curve:
    """A test as dense arrays (n,), in the order of the test; compression positive.

    time: laboratory clock [h]. stress: on the top platen [kPa]. strain: axial [1], from the end of seating on.
    stage: number of the stage in the program, from 0. others: base_stress, lateral_stress [kPa], ae_events [1].
    """

    time: np.ndarray
    stress: np.ndarray
    strain: np.ndarray
    stage: np.ndarray
    others: dict[str, np.ndarray] = field(default_factory=dict)

    def with_strain(self, strain: np.ndarray) -> "Curve":
        return replace(self, strain=strain)

    def windows(self) -> Iterator[tuple[int, slice, bool]]:
        """Each stage: its number, its rows with the one before, and whether it is a hold."""
        for stage in np.unique(self.stage):
            rows = np.flatnonzero(self.stage == stage)
            first, last = max(rows[0] - 1, 0), rows[-1]
            # By its ends: where grains break the stress dips for a moment.
            change = abs(self.stress[last] - self.stress[first])
            yield int(stage), slice(first, last + 1), change < 0.03 * self.stress[first]

    def without(self, *names: str) -> "Curve":
        return replace(self, others={k: v for k, v in self.others.items() if k not in names})


def readings(curve: Curve, ramp: int, hold: int) -> Curve:
    """The rows that a laboratory writes down: `ramp` evenly spaced in time, `hold` in its logarithm, of each stage."""
    names = {"stress": curve.stress, "strain": curve.strain, **curve.others}
    times, stages, values = [], [], {name: [] for name in names}
    for stage, window, rests in curve.windows():
        first, last = curve.time[window][[0, -1]]
        if rests:
            at = first + (last - first) * np.geomspace(1e-3, 1, hold)
        else:
            at = first + (last - first) * np.linspace(1 / ramp, 1, ramp)
        times.append(at)
        stages.append(np.full(len(at), stage))
        for name, channel in names.items():
            values[name].append(np.interp(at, curve.time[window], channel[window]))
    found = {name: np.concatenate(parts) for name, parts in values.items()}
    return Curve(
        np.concatenate(times),
        found.pop("stress"),
        found.pop("strain"),
        np.concatenate(stages),
        found,
    )
