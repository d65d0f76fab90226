"""The mechanisms put back into the model and run, with their size adjusted until the runs show what the recording does."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from grus.diagnosis.avalanche import Avalanche
from grus.diagnosis.base import Base
from grus.diagnosis.creep import Creep, course
from grus.diagnosis.estimate import Culprit
from grus.diagnosis.evidence import Explanation
from grus.diagnosis.layout import Layout
from grus.diagnosis.plan import INSTRUMENT
from grus.diagnosis.scaling import Scaling
from grus.diagnosis.search import next_strength
from grus.diagnosis.simulator import Simulator, Test
from grus.diagnosis.suspect import Known, Suspect
from grus.mechanisms import Parameter

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
    was. error (n,): standard error of its mean over the specimens. reproduced: effect on strain in the runs over the one that the
    recording asks for [-], in holds where one of several acts there and its size is sought. culprits: with the values that were run. specimens: that came to an end.
    between: the same of two runs with sizes of an Avalanche less than FARTHEST apart, one with less effect than is asked for and
    one with more, when there are such: in a few dozen grains nothing lies between no avalanche and one.
    """

    change: np.ndarray
    raw: np.ndarray
    error: np.ndarray
    reproduced: float
    culprits: tuple[Culprit, ...]
    specimens: int
    between: tuple[float, float] | None = None


def put_back(
    compared: Layout,
    simulator: Simulator,
    base: Base,
    seeds: Sequence[int],
    named: Sequence[Culprit],
    best: Explanation,
    suspects: Sequence[Suspect],
    scaling: Scaling,
) -> PutBack | None:
    """Runs the model with the mechanisms on, on a few specimens; None when no run came to an end.

    best: the explanation, whose effect is aimed at.
    """
    by_name = {s.name: s for s in suspects}
    members = [by_name[name] for name in best.names]
    sizes = dict(zip(best.names, best.best()))
    wanted = sum((m.effect(sizes[m.name])[0] for m in members), np.zeros(len(compared.measured)))
    ran = [m for m in members if isinstance(m, Known) and _name(m) not in INSTRUMENT]
    sought = _sought(ran)
    where = compared.where(channel="strain")
    if isinstance(sought, Avalanche):
        where &= sought.acts()
    culprits = tuple(named)
    tried: list[tuple[float, PutBack]] = []
    points = [] if sought is None else _points(sought, where, wanted, scaling)
    for _ in range(1 if sought is None else TRIALS):
        found = _run(compared, simulator, base, seeds, culprits, scaling)
        if found is None:
            break
        raw, error, count = found
        change = _smooth(raw, compared, members, sizes)
        share = _share(change, wanted, where)
        off = abs(np.log(max(share, 1e-6)))
        tried.append((off, PutBack(change, raw, error, share, culprits, count)))
        if sought is None or off < CLOSE:
            break
        following = _next(sought, culprits, share, points)
        if following is None:
            break
        culprits = following
    if not tried:
        return None
    found = min(tried, key=lambda one: one[0])[1]
    return replace(found, between=_between(points)) if isinstance(sought, Avalanche) else found


def _between(points: Sequence[tuple[float, float]]) -> tuple[float, float] | None:
    """Effects over the wanted one at the two closest sizes, of less and of more effect than is wanted."""
    sides = [
        (abs(np.log(less / more)), under, over)
        for less, under in points
        for more, over in points
        if under < 1 <= over
    ]
    apart, under, over = min(sides, default=(np.inf, 0.0, 0.0))
    return (under, over) if apart < np.log(FARTHEST) else None


def _sought(ran: Sequence[Known]) -> Known | None:
    """Of the mechanisms that are run, the one whose size is sought: the only one, or one whose effect in a few dozen grains is
    most uncertain."""
    uncertain = [m for m in ran if isinstance(m, Avalanche)]
    return next(iter(uncertain or (ran if len(ran) == 1 else ())), None)


def _run(
    compared: Layout,
    simulator: Simulator,
    base: Base,
    seeds: Sequence[int],
    culprits: Sequence[Culprit],
    scaling: Scaling,
) -> tuple[np.ndarray, np.ndarray, int] | None:
    on = tuple((c.name, _simulated(c, scaling)) for c in culprits)
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


def _share(change: np.ndarray, wanted: np.ndarray, where: np.ndarray) -> float:
    """Effect on the entries (n,) over the one that is wanted."""
    return float(change[where] @ wanted[where] / max(wanted[where] @ wanted[where], 1e-30))


def _simulated(culprit: Culprit, scaling: Scaling) -> tuple[tuple[str, float], ...]:
    """Values of the parameters in the runs."""
    return tuple(
        (one.name, scaling.simulated(culprit.name, one.unit) * one.value)
        for one in culprit.parameters
    )


def _smooth(
    raw: np.ndarray, compared: Layout, members: Sequence[Suspect], sizes: dict[str, float]
) -> np.ndarray:
    """Delayed strain of a few dozen grains comes in few steps: its amount, with the course of the law."""
    creep = next((m for m in members if isinstance(m, Creep)), None)
    if creep is None or len(members) > 1:
        return raw
    _, time, power, _ = creep.cases[int(sizes[creep.name])]
    holds = compared.where(kind="hold", channel="strain")
    return np.where(holds, raw[holds].sum() * course(compared, time, power), raw)


def _name(suspect: Suspect) -> str:
    return suspect.name.split(":")[0]


def _points(
    suspect: Known, where: np.ndarray, wanted: np.ndarray, scaling: Scaling
) -> list[tuple[float, float]]:
    """Value of the parameter and effect over the wanted one, of the sizes that gave the fingerprint."""
    one = suspect.fingerprint
    factor = scaling.simulated(_name(suspect), one.parameter.unit)
    return [
        (value / factor, _share(change, wanted, where))
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
    return _changed(culprits, own, parameter, value)


def _changed(
    culprits: Sequence[Culprit], own: Culprit, parameter: Parameter, value: float
) -> tuple[Culprit, ...]:
    before = own.parameters[0]
    off = parameter.off or 0.0
    # The interval is that of the fingerprint: it moves with the value that the runs ask for, on the same side of no effect.
    moved = (value - off) / (before.value - off) if before.value != off else 1.0
    low, high = sorted(
        min(max(off + moved * (end - off), parameter.low), parameter.high)
        for end in (before.low, before.high)
    )
    estimate = replace(before, value=value, low=low, high=high)
    changed = replace(own, parameters=(estimate, *own.parameters[1:]))
    return tuple(changed if c is own else c for c in culprits)
