"""Which measurement would tell explanations apart that a recording cannot."""

from collections.abc import Sequence

import numpy as np

from grus.diagnosis.evidence import Explanation
from grus.diagnosis.layout import RATIOS, Entry, Layout
from grus.diagnosis.library import Library
from grus.diagnosis.scatter import RATIO, RATIO_LEVEL, SETTLING
from grus.diagnosis.suspect import Known, Suspect
from grus.record import Record

LONGER = 10.0
"""Factor by which a hold would be longer."""
TELLING = 2.0
"""Expected difference, in standard deviations, from which a measurement is worth while."""
CHANNELS = {
    "base_stress": "record the stress at the base as well as at the top",
    "lateral_stress": "record the lateral stress",
}
STRAIGHT = ("instrument_drift",)
"""Mechanisms whose strain grows with time itself; others grow with its logarithm, or not at all."""


def next_measurement(
    recording: Record,
    compared: Layout,
    made: Library,
    found: Sequence[Explanation],
    suspects: Sequence[Suspect],
) -> str:
    """In words: the measurement in which the two most probable explanations differ most, in standard deviations."""
    if len(found) < 2:
        return ""
    by_name = {s.name: s for s in suspects}
    first, second = found[0], found[1]
    options = {
        f"hold the highest stress {LONGER:g} times as long": _longer_hold(
            compared, by_name, first, second
        )
    }
    for channel, words in CHANNELS.items():
        if channel not in recording.channels:
            options[words] = _ratio(made, suspects, RATIOS[channel], first, second)
    if "time" not in recording.channels:
        options["record the time of each reading, also in the holds"] = TELLING
    if not any(s.kind == "unload" for s in compared.protocol.segments):
        options["unload and reload once, before the highest stress"] = TELLING
    words, score = max(options.items(), key=lambda one: one[1])
    if score < TELLING:
        return (
            "the same test on further specimens: what these explanations differ by is less than specimens scatter, "
            "in every measurement that was considered"
        )
    return f"{words} (expected difference {score:.1f} standard deviations)"


def _longer_hold(
    compared: Layout, by_name: dict[str, Suspect], first: Explanation, second: Explanation
) -> float:
    holds = [e for e in compared.entries if e.kind == "hold" and e.channel == "strain"]
    if not holds:
        return 0.0
    highest = max(holds, key=lambda e: compared.protocol.segments[e.stage].stress_to).stage
    own = np.flatnonzero(compared.where(stage=highest, channel="strain"))
    ends = [compared.entries[i] for i in own]
    further = [_further(by_name, one, own, ends) for one in (first, second)]
    before = np.abs(compared.measured[compared.where(channel="strain", kind="load")]).max(initial=0)
    noise = np.sqrt(compared.noise[own[-1], own[-1]] + (SETTLING[1] * before) ** 2)
    return float(abs(further[0] - further[1]) / noise)


def _further(
    by_name: dict[str, Suspect], one: Explanation, own: np.ndarray, ends: Sequence[Entry]
) -> float:
    """Strain that a hold would go on by."""
    total = 0.0
    for name, size in zip(one.names, one.best()):
        change = by_name[name].effect(size)[0][own]
        if name.split(":")[0] in STRAIGHT:
            total += (LONGER - 1) * float(change.sum())
        else:
            late = ends[-1].start if ends[-1].start > 0 else 0.1
            total += float(change[-1]) / np.log(1 / min(late, 0.9)) * np.log(LONGER)
    return total


def _ratio(
    made: Library,
    suspects: Sequence[Suspect],
    channel: str,
    first: Explanation,
    second: Explanation,
) -> float:
    """Largest difference of a stress ratio at the end of a stage."""
    known = [s for s in suspects if isinstance(s, Known)]
    prints = {s.name: (s, ratios) for s, ratios in zip(known, made.ratios)}
    own = made.unrecorded.where(channel=channel)
    changes = []
    for one in (first, second):
        total = np.zeros(own.sum())
        for name, size in zip(one.names, one.best()):
            if name in prints:
                suspect, ratios = prints[name]
                total += ratios.at(suspect.of_fingerprint(size))[0][own]
        changes.append(total)
    scale = np.hypot(RATIO[channel], RATIO_LEVEL[channel])
    return float(np.abs(changes[0] - changes[1]).max(initial=0) / scale)
