"""Fingerprints between and beyond the sizes that were run."""

import numpy as np
import pytest
from formula import compared, made_test

from grus.diagnosis.fingerprint import BEYOND, Fingerprint, fingerprint
from grus.mechanisms import MECHANISMS, Parameter

BASE = compared(made_test())
CREEP = compared(made_test(creep=1e-4)).measured - BASE.measured


def made(**changes) -> Fingerprint:
    parameter = Parameter("x", "1", 0.0, 1e9, (1.0, 2.0), False, "", **{"off": 0.0} | changes)
    return Fingerprint(
        MECHANISMS["bond_ageing"],
        parameter,
        (1.0, 2.0),
        np.array([CREEP, 2.5 * CREEP]),
        np.zeros((2, len(CREEP))),
    )


@pytest.mark.parametrize(
    "effect, factor", [(0.0, 0), (0.5, 0.5), (1, 1), (1.5, 1.75), (2, 2.5), (3, 2.5 * BEYOND)]
)
def test_effect_is_linear_between_the_sizes_run(effect, factor):
    assert made().at(effect)[0] == pytest.approx(factor * CREEP)


@pytest.mark.parametrize("effect, value", [(0.5, 0.5), (1, 1.0), (1.5, 1.5), (2, 2.0), (3, 8.0)])
def test_value_of_a_parameter_that_starts_from_zero(effect, value):
    assert made().value(effect) == pytest.approx(value)


def test_value_of_a_parameter_that_weakens_upwards():
    ageing = MECHANISMS["bond_ageing"]
    time = ageing.parameters[0]
    one = Fingerprint(ageing, time, time.sizes[:2], np.array([CREEP, CREEP]), np.zeros((2, 1)))
    assert one.value(0.1) > one.value(1) == time.sizes[0] > one.value(1.5) > one.value(2)
    assert not one.outside(2.0) and one.outside(2.5)


def test_mean_of_pairs_and_its_error():
    pairs = [[(BASE.measured + f * CREEP, BASE.measured) for f in (0.8, 1.0, 1.2)]]
    one = fingerprint(
        MECHANISMS["bond_ageing"], MECHANISMS["bond_ageing"].parameters[0], (1e5,), pairs, BASE
    )
    assert one.changes[0].sum() == pytest.approx(CREEP.sum(), rel=1e-6)
    assert one.errors[0] == pytest.approx(0.2 * np.abs(CREEP) / np.sqrt(3), abs=1e-12)


def test_courses_of_holds_are_drawn_to_what_they_have_in_common():
    own = BASE.where(kind="hold", channel="strain")
    lumps = np.zeros(len(CREEP))
    lumps[np.flatnonzero(own)[[1, 5, 9]]] = 1e-5
    pairs = [[(BASE.measured + lumps, BASE.measured)]]
    one = fingerprint(
        MECHANISMS["bond_ageing"], MECHANISMS["bond_ageing"].parameters[0], (1e5,), pairs, BASE
    )
    for stage in {e.stage for e, h in zip(BASE.entries, own) if h}:
        hold = BASE.where(stage=stage)
        assert one.changes[0][hold].sum() == pytest.approx(lumps[hold].sum())
        shares = one.changes[0][hold] / max(lumps[hold].sum(), 1e-12)
        assert np.count_nonzero(shares) in (0, 3)


def test_one_specimen_that_rearranges_does_not_drown_the_others():
    friction = MECHANISMS["wall_friction"]
    own = BASE.where(kind="load", channel="strain")
    effect = np.where(own, 1e-5, 0.0)
    factors = (0.9, 0.95, 1.0, 1.05, 100.0)
    pairs = [[(BASE.measured + f * effect, BASE.measured) for f in factors]]
    one = fingerprint(friction, friction.parameters[0], (0.2,), pairs, BASE)
    assert one.changes[0][own] == pytest.approx(effect[own])
    assert (one.errors[0][own] < 0.2 * effect[own]).all()


def test_holds_that_cancel_share_no_course():
    own = np.flatnonzero(BASE.where(kind="hold", channel="strain"))
    first, second = ([i for i in own if BASE.entries[i].stage == stage] for stage in (1, 3))
    change = np.zeros(len(CREEP))
    change[first], change[second] = 1e-5, -1e-5
    change[second[0]] = -0.9e-5
    one = fingerprint(
        MECHANISMS["bond_ageing"],
        MECHANISMS["bond_ageing"].parameters[0],
        (1e5,),
        [[(BASE.measured + change, BASE.measured)]],
        BASE,
    )
    assert one.changes[0] == pytest.approx(change)
