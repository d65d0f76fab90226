"""The mechanisms put back into the model and run, with their size adjusted until the runs show what the recording does."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from grus.diagnosis.base import Base
from grus.diagnosis.creep import Creep, course
from grus.diagnosis.estimate import Culprit, simulated
from grus.diagnosis.evidence import Explanation
from grus.diagnosis.layout import Layout
from grus.diagnosis.plan import INSTRUMENT
from grus.diagnosis.search import next_strength
from grus.diagnosis.simulator import Simulator, Test
from grus.diagnosis.suspect import Known, Suspect

RUNS = 4
"""Specimens with which the model is run again."""
TRIALS = 5
"""Sizes that are tried, at most."""
FARTHEST = 8.0
"""Factor on a size to the next one, at most, where those of the fingerprint do not lie farther apart."""
CLOSE = 0.35
"""Difference in the logarithm of the effect at which a size is taken."""


@dataclass(frozen=True)
class PutBack:
    """change (n,): what the mechanisms changed in the runs, with the time course of delayed failure smoothed. raw (n,): as it
    was. error (n,): standard error of its mean over the specimens. reproduced: effect in the runs over the one that the
    recording asks for [-]. culprits: with the values that were run. specimens: that came to an end.
    """

    change: np.ndarray
    raw: np.ndarray
    error: np.ndarray
    reproduced: float
    culprits: tuple[Culprit, ...]
    specimens: int


def put_back(
    compared: Layout,
    simulator: Simulator,
    base: Base,
    seeds: Sequence[int],
    named: Sequence[Culprit],
    best: Explanation,
    suspects: Sequence[Suspect],
    stiffness: float,
) -> PutBack | None:
    """Runs the model with the mechanisms on, on a few specimens; None when no run came to an end.

    best: the explanation, whose effect is aimed at. stiffness: of the calibration, by which strains are multiplied.
    """
    by_name = {s.name: s for s in suspects}
    members = [by_name[name] for name in best.names]
    sizes = dict(zip(best.names, best.best()))
    wanted = sum((m.effect(sizes[m.name])[0] for m in members), np.zeros(len(compared.measured)))
    ran = [m for m in members if isinstance(m, Known) and _name(m) not in INSTRUMENT]
    culprits = tuple(named)
    tried: list[PutBack] = []
    points = _points(ran[0], compared, wanted) if len(ran) == 1 else []
    for _ in range(TRIALS if len(ran) == 1 else 1):
        found = _run(compared, simulator, base, seeds, culprits, stiffness)
        if found is None:
            break
        raw, error, count = found
        change = _smooth(raw, compared, members, sizes)
        share = _share(change, wanted, compared)
        tried.append(PutBack(change, raw, error, share, culprits, count))
        if not ran or abs(np.log(max(share, 1e-6))) < CLOSE:
            break
        following = _next(ran[0], culprits, share, points) if len(ran) == 1 else None
        if following is None:
            break
        culprits = following
    return min(tried, key=lambda t: abs(np.log(max(t.reproduced, 1e-6))), default=None)


def _run(
    compared: Layout,
    simulator: Simulator,
    base: Base,
    seeds: Sequence[int],
    culprits: Sequence[Culprit],
    stiffness: float,
) -> tuple[np.ndarray, np.ndarray, int] | None:
    on = tuple((c.name, _simulated(c, stiffness, compared.protocol.scale)) for c in culprits)
    pairs = [(Test(base, seed, on), Test(base, seed)) for seed in seeds[:RUNS]]
    records = simulator.run([test for pair in pairs for test in pair], "put back")
    changes = [
        compared.of(records[changed]) - compared.of(records[plain])
        for changed, plain in pairs
        if changed in records and plain in records
    ]
    if not changes:
        return None
    holds = compared.where(kind="hold", channel="strain")
    change = np.where(holds, np.mean(changes, axis=0), np.median(changes, axis=0))
    return change, np.std(changes, axis=0) / np.sqrt(len(changes)), len(changes)


def _share(change: np.ndarray, wanted: np.ndarray, compared: Layout) -> float:
    """Effect on strain over the one that is wanted."""
    strain = compared.where(channel="strain")
    return float(change[strain] @ wanted[strain] / max(wanted[strain] @ wanted[strain], 1e-30))


def _simulated(culprit: Culprit, stiffness: float, scale: float) -> tuple[tuple[str, float], ...]:
    """Values of the parameters in the runs."""
    return tuple(
        (one.name, simulated(culprit.name, one.unit, stiffness, scale) * one.value)
        for one in culprit.parameters
    )


def _smooth(
    raw: np.ndarray, compared: Layout, members: Sequence[Suspect], sizes: dict[str, float]
) -> np.ndarray:
    """Delayed strain of a few dozen grains comes in few steps: its amount, with the course of the law."""
    creep = next((m for m in members if isinstance(m, Creep)), None)
    if creep is None or len(members) > 1:
        return raw
    _, time, power = creep.cases[int(sizes[creep.name])]
    holds = compared.where(kind="hold", channel="strain")
    return np.where(holds, raw[holds].sum() * course(compared, time, power), raw)


def _name(suspect: Suspect) -> str:
    return suspect.name.split(":")[0]


def _points(suspect: Known, compared: Layout, wanted: np.ndarray) -> list[tuple[float, float]]:
    """Value of the parameter and effect over the wanted one, of the sizes that gave the fingerprint."""
    one = suspect.fingerprint
    factor = simulated(_name(suspect), one.parameter.unit, 1.0, compared.protocol.scale)
    return [
        (value / factor, _share(change, wanted, compared))
        for value, change in zip(one.sizes, one.changes)
    ]


def _next(
    suspect: Known, culprits: Sequence[Culprit], share: float, points: list[tuple[float, float]]
) -> tuple[Culprit, ...] | None:
    """The culprits with another value: where the runs so far, in the logarithm, say the effect is as wanted."""
    parameter = suspect.fingerprint.parameter
    own = next(c for c in culprits if c.name == _name(suspect))
    now = own.parameters[0].value
    off = parameter.off or 0.0
    # The fingerprint may have the same size, from fewer specimens.
    points[:] = [one for one in points if not np.isclose(one[0], now)] + [(now, share)]
    sizes = suspect.fingerprint.sizes
    strongest = sizes[-1] if len(sizes) > 1 else parameter.sizes[-1]
    apart = np.log(abs(strongest - off)) - np.log(abs(sizes[0] - off))
    upwards = -1.0 if apart < 0 else 1.0
    strengths = [
        (upwards * np.log(max(abs(v - off), 1e-12)), np.log(max(s, 1e-4))) for v, s in points
    ]
    place = upwards * next_strength(strengths, max(abs(apart), np.log(FARTHEST)))
    side = -1.0 if parameter.off is not None and points[0][0] < off else 1.0
    value = min(max(off + side * np.exp(place), parameter.low), parameter.high)
    if abs(value - now) <= 1e-3 * abs(now):
        return None
    return _changed(culprits, own, value)


def _changed(culprits: Sequence[Culprit], own: Culprit, value: float) -> tuple[Culprit, ...]:
    before = own.parameters[0]
    # The interval is that of the fingerprint: it moves with the value that the runs ask for.
    moved = value / before.value
    low, high = sorted((moved * before.low, moved * before.high))
    estimate = replace(before, value=value, low=low, high=high)
    changed = replace(own, parameters=(estimate, *own.parameters[1:]))
    return tuple(changed if c is own else c for c in culprits)
