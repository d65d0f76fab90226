"""Creep and collapse as suspects: the course by the law, the size by the DEM."""

from dataclasses import replace

import numpy as np
import pytest
from formula import compared, made_test

from grus.diagnosis.collapse import Collapse
from grus.diagnosis.creep import Creep, course, renewed
from grus.diagnosis.draining import Draining
from grus.diagnosis.evidence import explanations
from grus.diagnosis.fingerprint import Fingerprint
from grus.diagnosis.suspect import Known, Unknown
from grus.diagnosis.verdict import decide
from grus.mechanisms import MECHANISMS

CREEPING = made_test(noise=2e-6, creep=1e-4)
BASE = compared(made_test())
SCATTER = np.diag((0.1 * np.abs(BASE.measured) + 1e-6) ** 2)


def fingerprint(name: str, view, amounts) -> Fingerprint:
    """Of a mechanism that adds amounts of strain to the last hold of the DEM, by size."""
    parameter = MECHANISMS[name].parameters[0]
    changes = np.zeros((len(amounts), len(view.entries)))
    changes[:, np.flatnonzero(view.where(stage=3, channel="strain"))[-1]] = amounts
    return Fingerprint(
        MECHANISMS[name], parameter, parameter.sizes[: len(amounts)], changes, 0 * changes
    )


def test_shares_add_up_and_follow_the_logarithm():
    shares = course(BASE, 60.0, 2.0)
    assert shares.sum() == pytest.approx(1)
    own = np.flatnonzero(BASE.where(stage=3, channel="strain"))
    day = 24 * 3600.0
    entries = [BASE.entries[i] for i in own]
    grown = np.array([np.log((60 + e.end * day) / (60 + e.start * day)) for e in entries])
    assert shares[own] / shares[own].sum() == pytest.approx(grown / grown.sum(), rel=1e-3)


def test_less_stress_stops_it():
    """A hold at a tenth of the stress after the unloading."""
    record = made_test()
    last, hold = record.segments[-1], record.segments[-2]
    rows = np.arange(len(record), len(record) + 30)
    time = last.t1 + np.geomspace(1, 24 * 3600, 30)
    channels = {
        "time": np.append(record["time"], time),
        "axial_stress": np.append(record["axial_stress"], np.full(30, 50e3)),
        "axial_strain": np.append(record["axial_strain"], np.full(30, record["axial_strain"][-1])),
    }
    rest = replace(
        hold,
        stage=6,
        first=last.last,
        last=int(rows[-1]),
        t0=last.t1,
        t1=float(time[-1]),
        stress_from=50e3,
        stress_to=50e3,
    )
    view = compared(replace(record, channels=channels, segments=(*record.segments, rest)))
    unloaded = view.where(stage=5, channel="strain")
    assert unloaded.any()
    assert np.abs(course(view, 60.0, 2.0)[unloaded]).max() < 1e-6
    assert np.abs(renewed(view, 60.0, 2.0)[unloaded]).max() < 1e-6


def test_creep_is_named_of_any_amount():
    view = compared(CREEPING)
    suspects = [
        Creep(fingerprint("bond_ageing", view, [1e-5, 5e-3]), view),
        Unknown("hold", view, np.abs(BASE.measured)),
    ]
    found = explanations(view.measured - BASE.measured, SCATTER + view.noise, suspects)
    assert decide(found).named == ("bond_ageing",)


def test_size_lies_between_those_that_were_run_and_the_interval_holds_both():
    suspect = Creep(fingerprint("bond_ageing", BASE, [1e-5, 5e-3]), BASE)
    weak, strong = suspect.fingerprint.sizes
    size = next(k for k, (amount, *_) in enumerate(suspect.cases) if amount > 1e-4)
    assert strong < suspect.value(size) < weak
    assert set(suspect.bracket(size)) == {weak, strong}


def test_collapse_is_told_from_creep_by_its_jump():
    record = made_test(noise=2e-6)
    hold = record.segments[3]
    strain = record["axial_strain"] + 2e-4 * (record["time"] > (hold.t0 + hold.t1) / 2)
    view = compared(replace(record, channels=record.channels | {"axial_strain": strain}))
    plain = view.of(
        replace(made_test(), segments=tuple(replace(s, stage=s.stage) for s in record.segments))
    )
    suspects: list[Known] = [
        Creep(fingerprint("bond_ageing", view, [1e-5, 5e-3]), view),
        Collapse(fingerprint("wetting_collapse", view, [1e-5, 5e-3]), view),
    ]
    scatter = np.diag((0.1 * np.abs(plain) + 1e-6) ** 2)
    found = explanations(view.measured - plain, scatter + view.noise, suspects)
    assert decide(found).named == ("wetting_collapse",)
    best = next(e for e in found if e.names == ("wetting_collapse:strength_factor",)).best()[0]
    assert best == pytest.approx(2e-4, rel=0.6)


def test_pore_water_is_no_creep():
    """Strain lags behind each change of stress and comes to an end, after unloading too."""
    record = made_test(noise=2e-6)
    strain = record["axial_strain"].copy()
    for ramp, hold in zip(record.segments[:-1:2], record.segments[1::2]):
        own = slice(hold.first, hold.last + 1)
        passed = record["time"][own] - hold.t0
        late = 0.5 * (strain[ramp.last] - strain[ramp.first]) * (1 - np.exp(-passed / 3000))
        strain[own] += late
        strain[hold.last + 1 :] += late[-1]
    view = compared(replace(record, channels=record.channels | {"axial_strain": strain}))
    plain = view.of(made_test())
    scatter = np.diag((0.1 * np.abs(plain) + 1e-6) ** 2)
    suspects = [
        Creep(fingerprint("bond_ageing", view, [1e-5, 5e-3]), view),
        Draining(view),
        Unknown("hold", view, np.abs(plain)),
    ]
    found = explanations(view.measured - plain, scatter + view.noise, suspects)
    assert decide(found).kind == "unknown"
    assert found[0].names == ("unknown:draining",)


def test_bonds_may_fail_and_move_little():
    """Acoustic events of a hold that come with less strain than usual are no evidence against creep, nor alone for it."""
    record = CREEPING
    events = np.cumsum(np.ones(len(record)))
    heard = replace(
        record,
        channels=record.channels | {"ae_events": events},
        units=record.units | {"ae_events": "1"},
    )
    view = compared(heard)
    suspect = Creep(fingerprint("bond_ageing", view, [1e-5, 5e-3]), view)
    entries = view.where(channel="events")
    for size in (suspect.grid[0], suspect.grid[-1]):
        _, spread = suspect.effect(size)
        assert (np.sqrt(np.diag(spread)[entries]) >= 0.1).all()


@pytest.mark.parametrize("parts", [400, 3])
def test_creep_in_many_steps_or_in_few(parts):
    """The strain of the last hold comes in steps of equal height at times drawn evenly over the logarithm."""
    record = made_test(noise=2e-6)
    hold = record.segments[3]
    generator = np.random.default_rng(5)
    times = np.exp(generator.uniform(np.log(60), np.log(24 * 3600), parts))
    passed = record["time"] - hold.t0
    steps = 6e-4 * (passed[:, None] > times).mean(axis=1)
    view = compared(
        replace(record, channels=record.channels | {"axial_strain": record["axial_strain"] + steps})
    )
    plain = view.of(made_test())
    suspects = [
        Creep(fingerprint("bond_ageing", view, [1e-5, 5e-3]), view),
        Draining(view),
        Unknown("hold", view, np.abs(plain)),
    ]
    scatter = np.diag((0.1 * np.abs(plain) + 1e-6) ** 2)
    found = explanations(view.measured - plain, scatter + view.noise, suspects)
    assert decide(found).named == ("bond_ageing",)
