"""What a prepared specimen is like, in the plane and in space."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

from grus.preparation import PreparedSpecimen, make, prepare
from grus.preparation.diameters import diameters
from grus.preparation.grain import sized_grain
from grus.preparation.preparation import specimen_key
from grus.preparation.press import Press
from grus.scene import grain_material

CARDS = ["plane", "solid"]


@pytest.fixture(params=CARDS)
def pair(request):
    """A card and its prepared specimen."""
    name = request.param
    return request.getfixturevalue(name), request.getfixturevalue(f"prepared_{name}")


def test_void_ratio_is_met(pair):
    card, prepared = pair
    assert abs(prepared.void_ratio - card.specimen.void_ratio) <= 0.005
    assert prepared.void_ratio_elements > prepared.void_ratio
    assert prepared.height == pytest.approx(card.specimen.height, rel=0.06)


def test_grains_are_those_of_the_grading(pair):
    card, prepared = pair
    assert prepared.specimen.grain_diameter == pytest.approx(diameters(card))
    for number in (0, 5):
        own = prepared.specimen.grain == number
        alone = sized_grain(card, number, float(prepared.specimen.grain_diameter[number]))
        assert (
            np.unique(prepared.specimen.clump[own], return_inverse=True)[1] == alone.clump
        ).all()
        here = prepared.specimen.position[own]
        apart = [np.linalg.norm(p[:, None] - p[None], axis=2) for p in (here, alone.position)]
        # Places are rounded to a grid of up to 2^-25 of a radius, see `on_grid`.
        grid = card.element.radius * 2.0**-25
        np.testing.assert_allclose(*apart, rtol=0, atol=2 * grid)


def test_nothing_has_moved_into_anything(pair):
    card, prepared = pair
    s, r = prepared.specimen, card.element.radius
    pairs = cKDTree(s.position).query_pairs(2 * r, output_type="ndarray")
    foreign = pairs[s.grain[pairs[:, 0]] != s.grain[pairs[:, 1]]]
    gap = np.linalg.norm(s.position[foreign[:, 0]] - s.position[foreign[:, 1]], axis=1) - 2 * r
    assert len(foreign) > prepared.specimen.grain_count / 2
    assert gap.min() > -1e-3 * r
    axes = slice(card.dimension)
    assert (s.position[:, axes] - r > prepared.lower - 1e-3 * r).all()
    assert (s.position[:, axes] + r < prepared.upper + 1e-3 * r).all()


def test_it_rests_under_the_seating_stress_and_no_bond_is_near_breaking(pair):
    card, prepared = pair
    stress = card.preparation.seating_stress
    assert prepared.axial_stress == pytest.approx(stress, rel=0.02)
    assert prepared.unbalanced <= 2 * card.preparation.unbalanced_limit
    assert prepared.side_stress > 0
    assert 0 < prepared.largest_tension < 0.5 * card.bond.tensile_strength
    assert 0 < prepared.largest_shear < 0.5 * card.bond.shear_strength


def test_equilibrium_is_found_again_from_the_arrays(pair):
    card, prepared = pair
    corners = np.array([prepared.lower, prepared.upper])
    press = Press(card, prepared.specimen, corners, grain_material(card), 0.01)
    press.bond()
    press.to_rest()
    assert press.engines.ledger.breaks == 0
    assert press.void_ratio == pytest.approx(prepared.void_ratio, abs=2e-4)
    moved = np.linalg.norm(press.positions() - prepared.specimen.position, axis=1)
    assert np.median(moved) < 0.01 * card.element.radius


def test_saved_and_read_back_bit_by_bit(pair, tmp_path):
    _, prepared = pair
    prepared.save(tmp_path / "specimen.h5")
    again = PreparedSpecimen.load(tmp_path / "specimen.h5")
    assert again.specimen.content_hash() == prepared.specimen.content_hash()
    assert (again.lower == prepared.lower).all() and (again.upper == prepared.upper).all()
    assert again.void_ratio == prepared.void_ratio and again.key == prepared.key


def test_found_again_where_it_was_kept(pair, folder, monkeypatch):
    card, prepared = pair
    monkeypatch.setattr("grus.preparation.preparation.make", None)
    again = prepare(card.with_overrides({"name": "other", "crush.speed": "1 m/s"}), folder)
    assert again.specimen.content_hash() == prepared.specimen.content_hash()


@pytest.mark.parametrize(
    "change",
    [
        {"seed": 2},
        {"specimen.void_ratio": 0.26},
        {"preparation.seating_stress": "6 kPa"},
        {"element.radius": "0.8 mm"},
        {"contact.friction_coefficient": 0.4},
    ],
)
def test_key_knows_what_made_it(plane, change):
    assert specimen_key(plane.with_overrides(change)) != specimen_key(plane)


def test_key_leaves_out_what_did_not_make_it(plane):
    with_others = {"crush.speed": "1 m/s", "name": "other"}
    assert specimen_key(plane.with_overrides(with_others)) == specimen_key(plane)


def test_same_seed_same_specimen(solid, prepared_solid):
    again = make(solid)
    assert again.specimen.content_hash() == prepared_solid.specimen.content_hash()
    assert (again.lower == prepared_solid.lower).all()
    assert (again.upper == prepared_solid.upper).all()
