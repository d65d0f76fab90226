"""A specimen in YADE has the mass, place, bonds and fragments that it has in Python."""

from pathlib import Path

import numpy as np
import pytest

import grus  # noqa: F401  loads YADE
from grus.card import Card
from grus.errors import GrusError
from grus.scene import InteractionEngines, bond, grain_material, insert, snapshot
from grus.scene.snapshot import fragments
from grus.specimen import clump_properties
from grus.specimen.from_card import grain_from_card
from yade import O
from yade.wrapper import NewtonIntegrator

MODELS = Path(__file__).parents[3] / "models"
CARDS = ["montesinho.toml", "montesinho-3d.toml"]


@pytest.fixture(params=CARDS)
def scene(request):
    O.reset()
    card = Card.from_file(MODELS / request.param)
    specimen = grain_from_card(card, 7)
    ids = insert(specimen, grain_material(card), first_grain=7)
    yield card, specimen, ids
    O.reset()


def test_elements_are_where_they_should_be(scene):
    _, specimen, ids = scene
    np.testing.assert_array_equal([O.bodies[i].state.pos for i in ids], specimen.position)
    assert [O.bodies[i].shape.radius for i in ids] == specimen.radius.tolist()
    assert {O.bodies[i].state.grain for i in ids} == {7}
    assert [O.bodies[i].state.element for i in ids] == list(range(len(ids)))


def test_clumps_have_the_mass_and_inertia_of_their_elements(scene):
    card, specimen, ids = scene
    properties = clump_properties(specimen, card.element.density)
    for clump in range(specimen.clump_count):
        members = np.flatnonzero(specimen.clump == clump)
        body = O.bodies[ids[members[0]]]
        if len(members) > 1:
            assert all(O.bodies[ids[m]].clumpId == body.clumpId for m in members)
            body = O.bodies[body.clumpId]
        assert body.state.mass == properties.mass[clump]
        np.testing.assert_allclose(body.state.pos, properties.centre[clump], atol=1e-15)
        turn = np.array(body.state.ori.toRotationMatrix()).reshape(3, 3)
        inertia = turn @ np.diag(body.state.inertia) @ turn.T
        if specimen.dimension == 2:
            assert inertia[2, 2] == properties.inertia[clump][2, 2]
            assert body.state.blockedDOFs == "zXY" and not body.aspherical
        else:
            scale = np.abs(properties.inertia[clump]).max()
            np.testing.assert_allclose(inertia, properties.inertia[clump], atol=1e-12 * scale)


def test_bonds_and_snapshot(scene):
    _, specimen, ids = scene
    engines = InteractionEngines()
    O.engines = engines.list + [NewtonIntegrator()]
    assert bond(specimen, engines) == len(specimen.bonds())
    state = snapshot(specimen, ids)
    np.testing.assert_array_equal(state.bonds, specimen.bonds())
    np.testing.assert_allclose(state.position, specimen.position, rtol=0, atol=1e-17)
    assert state.fragment_count == 1 and not len(state.broken)


def test_nothing_moves_without_load(scene):
    _, specimen, ids = scene
    engines = InteractionEngines()
    O.engines = engines.list + [NewtonIntegrator(damping=0)]
    bond(specimen, engines)
    O.dt = 1e-7
    O.run(200, True)
    moved = np.abs(snapshot(specimen, ids).position - specimen.position).max()
    assert moved < 1e-12 * specimen.radius[0]


def test_missing_bonds_are_noticed(scene):
    _, specimen, ids = scene
    O.bodies[ids[0]].state.grain = 8
    engines = InteractionEngines()
    O.engines = engines.list + [NewtonIntegrator()]
    with pytest.raises(GrusError, match="bonds made"):
        bond(specimen, engines)


def test_fragments_are_numbered_by_size():
    clump = np.array([0, 0, 1, 2, 3, 3, 3])
    bonds = np.array([[1, 2], [3, 4]])  # clumps 0-1 and 2-3
    np.testing.assert_array_equal(fragments(clump, bonds), [1, 1, 1, 0, 0, 0, 0])
    none = np.empty((0, 2), dtype=int)
    assert len(set(fragments(clump, none))) == 4
