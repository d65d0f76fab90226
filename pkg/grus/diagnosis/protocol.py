"""What was done to the specimen of a recording, as stages that a card can state."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from grus.diagnosis.jump import Jump, largest_jump
from grus.errors import GrusError
from grus.record import Record, Segment
from grus.recording import read_program

LEAST_MOVE = 0.03
"""Changes of stress below this share of the highest stress are no stage of their own."""
LOWEST = 0.01
"""Stresses below this share of the highest are simulated at it: a servo cannot hold next to nothing."""
UNKNOWN_HOLD, UNKNOWN_LOAD = 24 * 3600.0, 3600.0
"""Length of a hold and of a change of stress [s] when the recording has no times."""
SAME = 0.06
"""Difference of two stresses, as a share, at which they are taken for one that is reached again."""
STRESSES = (1e5, 2e6)
"""Highest stresses [Pa] that are simulated as they are. Strains go with stress over stiffness and stress over strength, so that
others are simulated at a tenth, ten times, ... of them, with strengths to match and a stiffness that is calibrated."""
LOADS_A_DECADE, HOLDS_A_DECADE = 3, 10
"""Steps of duration: what ages goes with the logarithm of time, and tests of like programs share their runs."""
ANY = 3600.0
"""Length of all stages [s] where the laboratory clock does not matter."""


@dataclass(frozen=True)
class Protocol:
    """Stages of a card, and for each the segment of the recording that it follows.

    stages: in the words of a card, stresses and times rounded. timeless: the same with one duration for all, for
    models in which the laboratory clock changes nothing. lead: number of stages that come before those of the
    recording, 1 when it begins under load. segments: of the recording, one for each further stage. timed: whether the
    recording has times. seating: axial stress [Pa] at which the recording begins, as it can be simulated. highest: axial stress [Pa]
    of the recording's stages. scale: stresses that are simulated over those of the recording. jump: the largest jump of
    strain at constant stress, if there is one.
    """

    stages: tuple[str, ...]
    timeless: tuple[str, ...]
    segments: tuple[Segment, ...]
    timed: bool
    seating: float
    highest: float
    scale: float = 1.0
    lead: int = 0
    jump: Jump | None = None

    @property
    def hours(self) -> float:
        """Length of the test [h]; 0 without times."""
        return (self.segments[-1].t1 - self.segments[0].t0) / 3600 if self.timed else 0.0


def protocol(record: Record, program: Sequence[str] | None = None) -> Protocol:
    """The stages of a record that has been cut into segments, by its program where that is known.

    Raises GrusError when nothing is loaded in it.
    """
    parts = [s for s in record.segments if s.kind != "event"]
    highest = max((max(s.stress_from, s.stress_to) for s in parts), default=0.0)
    if highest <= 0:
        raise GrusError("recording: the stress never rises; allowed: a test under load")
    lowest = LOWEST * highest
    timed = "time" in record.channels
    stated = {} if program is None else _stated(program)
    stages: list[tuple[str, float, float]] = []
    followed: list[Segment] = []
    under_load = parts[0].kind == "hold" and parts[0].stress_from > 2 * LEAST_MOVE * highest
    level = seating = max(min(parts[0].stress_from, 0.5 * highest), lowest)
    levels: list[float] = []
    if under_load:
        level = _nice(parts[0].stress_from)
        levels.append(level)
        stages.append(("load", level, UNKNOWN_LOAD))
    for part in parts:
        target = max(part.stress_to, lowest)
        if abs(target - level) > LEAST_MOVE * highest:
            kind = "load" if target > level else "unload"
            goal = _again(stated.get(part.stage, target), target, levels)
            seconds = part.t1 - part.t0 if timed and part.t1 > part.t0 else UNKNOWN_LOAD
            stages.append((kind, goal, _round(seconds, LOADS_A_DECADE)))
            level = target
            levels.append(goal)
        elif part.kind == "hold" and stages:
            seconds = part.t1 - part.t0 if timed else UNKNOWN_HOLD
            if seconds <= 0:
                continue
            stages.append(("hold", level, _round(seconds, HOLDS_A_DECADE)))
        else:
            continue
        followed.append(part)
    if not followed or stages[0][0] != "load":
        raise GrusError("recording: the stress never rises; allowed: a test under load")
    scale = _scale(max(levels))
    return Protocol(
        tuple(_worded(kind, scale * goal, seconds) for kind, goal, seconds in stages),
        tuple(_worded(kind, scale * goal, ANY) for kind, goal, _ in stages),
        tuple(followed),
        timed,
        seating,
        max(levels),
        scale,
        int(under_load),
        largest_jump(record, followed),
    )


def _worded(kind: str, stress: float, seconds: float) -> str:
    return (
        f"hold for {seconds:g} s" if kind == "hold" else f"{kind} to {stress:g} Pa in {seconds:g} s"
    )


def _scale(highest: float) -> float:
    """Power of ten that brings the highest stress among those for which the small model is made."""
    low, high = STRESSES
    powers = [p for p in range(-9, 10) if low <= highest * 10.0**p < high]
    return 1.0 if low <= highest < high else 10.0 ** min(powers, key=abs)


def _stated(program: Sequence[str]) -> dict[int, float]:
    """Stresses [Pa] that the program states, by the number of the stage."""
    stages = read_program(program)
    return {n: float(s.stress) for n, s in enumerate(stages, start=1) if s.stress is not None}


def _again(stated: float, reached: float, before: Sequence[float]) -> float:
    """The stress that the program states, if it was reached; one that was reached before; or the one that was reached, rounded."""
    if stated != reached and abs(stated - reached) <= SAME * stated:
        return stated
    near = [one for one in before if abs(one - reached) <= SAME * reached]
    return near[-1] if near else _nice(reached)


def _round(seconds: float, steps: int) -> float:
    """To so many steps a decade."""
    return float(f"{10 ** (round(steps * np.log10(seconds)) / steps):.3g}")


def _nice(stress: float) -> float:
    """To about two per cent, so that the noise of a recording makes no other program."""
    digit = 10 ** np.floor(np.log10(stress))
    step = next(step for below, step in ((2, 0.05), (5, 0.1), (10, 0.25)) if stress < below * digit)
    return float(f"{round(stress / digit / step) * step * digit:.3g}")
