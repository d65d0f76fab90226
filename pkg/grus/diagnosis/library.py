"""Fingerprints of all mechanisms under one protocol, and what calibration could still change."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from grus.diagnosis.base import Base
from grus.diagnosis.fingerprint import Fingerprint, fingerprint
from grus.diagnosis.layout import RATIOS, Layout, layout
from grus.diagnosis.plan import FRICTION, PAIRED, SEEDS, WHOLE, Direction
from grus.diagnosis.scatter import Scatter, scatter
from grus.diagnosis.simulator import Simulator, Test
from grus.errors import GrusError
from grus.record import Record

SPREAD = {"strength": 1.0, "friction": 0.2, "stiffness": 0.6}
"""Standard deviation of the ordinary parameters after calibration: of the strength in its steps, else of logarithms."""


@dataclass(frozen=True)
class Library:
    """scatter: of the base. nuisances (q, n): change of the vector by one standard deviation of each ordinary
    parameter. fingerprints: of the mechanisms. skipped: those whose runs did not come to an end, with the reason.
    plain: records of the base, by seed. ratios: by the name of a suspect, the same fingerprint for the stress ratios at
    the ends of all stages, recorded or not, in the layout `unrecorded`.
    """

    scatter: Scatter
    nuisances: np.ndarray
    fingerprints: tuple[Fingerprint, ...]
    skipped: dict[str, str]
    plain: dict[int, Record]
    unrecorded: Layout
    ratios: tuple[Fingerprint, ...]

    @property
    def covariance(self) -> np.ndarray:
        """Of a recording's difference from the base when nothing is left out, without its noise (n, n)."""
        return self.scatter.covariance + self.nuisances.T @ self.nuisances


def library(
    measured: Layout,
    simulator: Simulator,
    base: Base,
    seeds: Sequence[int],
    wanted: Sequence[Direction],
    recording: Record,
) -> Library:
    """Makes the runs that are missing. Raises GrusError when the base itself cannot be simulated."""
    unrecorded = _unrecorded(recording, measured)
    plain = simulator.run([Test(base, seed) for seed in seeds[:SEEDS]], "base")
    every = [test.seed for test in plain]
    whole = base.unbreakable()
    elastic = simulator.run([Test(whole, seed) for seed in every], "without breakage")
    if len(plain) < 2 or not elastic:
        raise GrusError(_failure(simulator))
    without = plain | elastic
    off = {test.seed: measured.of(record) for test, record in plain.items()}
    scattered = scatter(
        measured,
        np.array(list(off.values())),
        np.median([measured.of(record) for record in elastic.values()], axis=0),
    )
    nuisances = _nuisances(measured, simulator, base, without, every)
    tests = {
        (d, size): [
            Test(off, seed, ((d.mechanism.name, d.values(size)),))
            for off, seed in _paired(base, d, every)
        ]
        for d in wanted
        for size in d.sizes
        if not d.free
    }
    # First one specimen of each at its weakest size: when time runs out, none has been left aside.
    order = [
        (number, d.sizes.index(size), test)
        for (d, size), of in tests.items()
        for number, test in enumerate(of)
    ]
    order.sort(key=lambda one: one[:2])
    on = simulator.run([test for _, _, test in order], "fingerprints")
    found, ratios, skipped = [], [], {}
    for d in wanted:
        pairs, sizes = [], []
        for size in d.sizes:
            if d.free:
                written = [
                    (d.mechanism.distort(record, dict(d.values(size))), record)
                    for record in plain.values()
                ]
            else:
                written = [
                    (on[test], without[replace(test, mechanisms=())])
                    for test in tests[d, size]
                    if test in on and replace(test, mechanisms=()) in without
                ]
            if written:
                pairs.append(written)
                sizes.append(size)
        if not pairs:
            skipped[d.mechanism.name] = "no run came to an end"
            continue
        for into, compared in ((found, measured), (ratios, unrecorded)):
            vectors = [[(compared.of(on), compared.of(off)) for on, off in p] for p in pairs]
            into += [
                fingerprint(d.mechanism, d.parameter, sizes, vectors, compared, sign)
                for sign in d.signs
            ]
    by_seed = {test.seed: record for test, record in plain.items()}
    return Library(scattered, nuisances, tuple(found), skipped, by_seed, unrecorded, tuple(ratios))


def _unrecorded(recording: Record, measured: Layout) -> Layout:
    """As if all ratios of stresses had been recorded."""
    stress = recording["axial_stress"]
    units = recording.units | {name: "Pa" for name in RATIOS}
    channels = recording.channels | {name: stress for name in RATIOS}
    return layout(replace(recording, channels=channels, units=units), measured.protocol)


def _paired(base: Base, direction: Direction, seeds: Sequence[int]) -> list[tuple[Base, int]]:
    """What a mechanism is switched on in."""
    if direction.mechanism.name in WHOLE:
        return [(base.unbreakable(), seed) for seed in seeds]
    return [(base, seed) for seed in seeds[:PAIRED]]


def _nuisances(
    measured: Layout,
    simulator: Simulator,
    base: Base,
    without: dict[Test, Record],
    seeds: Sequence[int],
) -> np.ndarray:
    whole = base.unbreakable()
    changed = {"friction": (whole, replace(whole, friction=FRICTION), np.log(FRICTION))}
    if base.strength is not None:
        # Towards the stronger: weaker specimens may collapse.
        changed["strength"] = (base, replace(base, strength=base.strength + 1), 1.0)
    tests = {
        name: [Test(on, seed) for seed in (seeds if on.strength is None else seeds[:PAIRED])]
        for name, (_, on, _) in changed.items()
    }
    records = simulator.run([t for of in tests.values() for t in of], "ordinary parameters")
    middle = np.median([measured.of(r) for t, r in without.items() if t.base == base], axis=0)
    # Strain goes as 1/stiffness.
    rows = [SPREAD["stiffness"] * np.where(measured.where(channel="strain"), middle, 0.0)]
    for name, (off, _, size) in changed.items():
        differences = [
            measured.of(records[t]) - measured.of(without[Test(off, t.seed)])
            for t in tests[name]
            if t in records and Test(off, t.seed) in without
        ]
        if differences:
            rows.append(np.median(differences, axis=0) * SPREAD[name] / size)
    return np.array(rows)


def _failure(simulator: Simulator) -> str:
    reasons = {o.failed for o in simulator.outcomes.values() if o.failed}
    why = "; ".join(sorted(reasons)[:2]) or "no time was left"
    return f"{simulator.card.source}: the recording's test cannot be simulated: {why}"
