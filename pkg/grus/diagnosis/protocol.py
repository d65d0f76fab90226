"""What was done to the specimen of a recording, as stages that a card can state."""

from dataclasses import dataclass

import numpy as np

from grus.errors import GrusError
from grus.record import Record, Segment

LEAST_MOVE = 0.03
"""Changes of stress below this share of the highest stress are no stage of their own."""
LOWEST = 0.01
"""Stresses below this share of the highest are simulated at it: a servo cannot hold next to nothing."""
UNKNOWN_HOLD = 24 * 3600.0
"""Length of a hold [s] when the recording has no times."""


@dataclass(frozen=True)
class Protocol:
    """Stages of a card, and for each the segment of the recording that it follows.

    stages: in the words of a card, stresses and times rounded. lead: number of stages that come before those of the
    recording, 1 when it begins under load. segments: of the recording, one for each further stage. timed: whether the
    recording has times. seating: axial stress [Pa] at which the recording begins, as it can be simulated.
    """

    stages: tuple[str, ...]
    segments: tuple[Segment, ...]
    timed: bool
    seating: float
    lead: int = 0

    @property
    def highest(self) -> float:
        """Highest axial stress [Pa]."""
        return max(s.stress_to for s in self.segments)

    @property
    def hours(self) -> float:
        """Length of the test [h]; 0 without times."""
        return (self.segments[-1].t1 - self.segments[0].t0) / 3600 if self.timed else 0.0


def protocol(record: Record) -> Protocol:
    """The stages of a record that has been cut into segments.

    Raises GrusError when nothing is loaded in it.
    """
    parts = [s for s in record.segments if s.kind != "event"]
    highest = max((max(s.stress_from, s.stress_to) for s in parts), default=0.0)
    if highest <= 0:
        raise GrusError("recording: the stress never rises; allowed: a test under load")
    lowest = LOWEST * highest
    timed = "time" in record.channels
    stages, followed = [], []
    under_load = parts[0].kind == "hold" and parts[0].stress_from > 2 * LEAST_MOVE * highest
    level = seating = max(min(parts[0].stress_from, 0.5 * highest), lowest)
    if under_load:
        level = parts[0].stress_from
        stages.append(f"load to {_nice(level):g} Pa")
    for part in parts:
        target = max(part.stress_to, lowest)
        if abs(target - level) > LEAST_MOVE * highest:
            kind = "load" if target > level else "unload"
            lasting = f" in {_round(part.t1 - part.t0):g} s" if timed and part.t1 > part.t0 else ""
            stages.append(f"{kind} to {_nice(target):g} Pa{lasting}")
            level = target
        elif part.kind == "hold" and stages:
            seconds = part.t1 - part.t0 if timed else UNKNOWN_HOLD
            if seconds <= 0:
                continue
            stages.append(f"hold for {_round(seconds):g} s")
        else:
            continue
        followed.append(part)
    if not followed or not stages[0].startswith("load"):
        raise GrusError("recording: the stress never rises; allowed: a test under load")
    return Protocol(tuple(stages), tuple(followed), timed, seating, int(under_load))


def _round(seconds: float) -> float:
    """To ten steps a decade: ageing goes with the logarithm of time, and tests of like programs share their runs."""
    return float(f"{10 ** (round(10 * np.log10(seconds)) / 10):.3g}")


def _nice(stress: float) -> float:
    """To about one per cent, so that the noise of a recording makes no other program."""
    digit = 10 ** np.floor(np.log10(stress))
    step = 0.05 if stress < 5 * digit else 0.1
    return float(f"{round(stress / digit / step) * step * digit:.3g}")
