"""Contacts and states of a scene as arrays, against what YADE's objects say one by one."""

from pathlib import Path

import numpy as np
import pytest

import grus  # first, since it loads YADE
from grus import _engines
from grus.card import Card
from grus.crushing import CrushingTest
from grus.scene import contacts, snapshot
from grus.scene.contacts import NO_ELEMENT, contact_table
from yade import O

MODELS = Path(__file__).parents[3] / "models"


@pytest.fixture(scope="module")
def crushed():
    """A plane grain between platens, some of its bonds broken."""
    O.reset()
    card = Card.from_file(MODELS / "montesinho.toml").with_overrides({"crush.speed": "0.1 m/s"})
    test = CrushingTest(card, 3)
    while test.engines.ledger.breaks < 10:
        O.run(1000, True)
    yield test
    O.reset()


def test_contacts_are_those_of_yade(crushed):
    index = {body: i for i, body in enumerate(crushed.ids)}
    wanted = {}
    for one in O.interactions:
        pair = tuple(sorted((index.get(one.id1, NO_ELEMENT), index.get(one.id2, NO_ELEMENT))))
        force = one.phys.normalForce.dot(one.geom.normal)
        wanted[pair] = (force, one.phys.bonded, one.phys.breakage, *one.geom.contactPoint)
    table = contact_table(crushed.ids)
    found = {
        tuple(pair): (force, bonded, breakage, *point)
        for pair, force, bonded, breakage, point in zip(
            table["pairs"].tolist(),
            table["force"],
            table["bonded"],
            table["breakage"],
            table["point"].tolist(),
        )
    }
    assert found == wanted and list(found) == sorted(found)


def test_compression_of_the_platens_is_positive(crushed):
    """Forces on the walls add up to the force that the platens measure."""
    found = contacts(crushed.ids)
    on_walls = found.pairs[:, 0] == NO_ELEMENT
    assert on_walls.any() and (found.force[on_walls] > 0).all()
    measured = O.forces.f(crushed.platens.top)[1] - O.forces.f(crushed.platens.bottom)[1]
    assert found.force[on_walls].sum() == pytest.approx(measured, rel=1e-12)


def test_snapshot_is_that_of_yade(crushed):
    state = snapshot(crushed.specimen, crushed.ids)
    states = [O.bodies[i].state for i in crushed.ids]
    np.testing.assert_array_equal(state.position, [one.pos for one in states])
    np.testing.assert_array_equal(state.velocity, [one.vel for one in states])
    assert len(state.bonds) == crushed.bonds - crushed.engines.ledger.breaks
    assert len(state.broken) == len(state.mode) > 0 and set(state.mode) <= {1, 2}


@pytest.mark.parametrize("body", [-1, 10**6])
def test_unknown_body_is_refused(crushed, body):
    with pytest.raises(ValueError, match=rf"bodyTable\(ids\) = {body}; allowed: ids of bodies"):
        _engines.bodyTable([body])


def test_scene_without_contacts():
    O.reset()
    found = contacts([0, 1])
    assert found.pairs.shape == (0, 2) and found.force.shape == (0,) and found.point.shape == (0, 3)
