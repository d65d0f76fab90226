"""Stages of a recording in words."""

from typing import Protocol

from grus.diagnosis.diagnosis import Diagnosis
from grus.diagnosis.report.spoken import quantity

KINDS = {"seat": "seating", "load": "loading", "reload": "reloading", "unload": "unloading"}
CHANNELS = {
    "strain": "strain",
    "base": "stress at the base",
    "lateral": "lateral stress",
    "events": "acoustic events in holds",
}


class Stage(Protocol):
    """What a segment of a recording and its misfit have in common."""

    stage: int
    kind: str
    t0: float | None
    t1: float | None
    stress_from: float
    stress_to: float


def done(stage: Stage) -> str:
    """As in "hold at 200 kPa for 4.4 h" or "loading to 500 kPa"."""
    stress = quantity(stage.stress_to, "Pa")
    if stage.kind != "hold":
        return f"{KINDS[stage.kind]} to {stress}"
    lasting = "" if stage.t0 is None else f" for {quantity(stage.t1 - stage.t0, 's')}"
    return f"hold at {stress}{lasting}"


def numbers(diagnosis: Diagnosis, which: tuple[int, ...]) -> str:
    """Stages of the protocol by their numbers in the recording, as in "stages 5 to 8"."""
    found = sorted({diagnosis.protocol.segments[k].stage for k in which})
    if len(found) == 1:
        return f"stage {found[0]}"
    if len(found) > 2 and found == list(range(found[0], found[-1] + 1)):
        return f"stages {found[0]} to {found[-1]}"
    return f"stages {', '.join(str(n) for n in found[:-1])} and {found[-1]}"
