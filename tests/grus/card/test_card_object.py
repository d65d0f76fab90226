"""A good card: values, defaults, copies, overrides."""

import copy
import math
import pickle

import pytest

from grus.card import Card


def test_values_are_floats_in_si(plane):
    assert plane.dimension == 2 and plane.seed == 1 and plane.thickness == 1.0
    assert plane.element.radius == 0.0006 and plane.element.density == 2052.0
    assert plane.contact.normal_stiffness == plane.contact.shear_stiffness == 3e9
    assert plane.bond.tensile_strength == plane.bond.shear_strength == 1e6
    assert plane.agglomerate.diameter == 0.0126
    assert plane.agglomerate.stamp_radius == 0.001 and plane.agglomerate.stamp_deviation == 0.0002
    assert isinstance(plane.element.radius, float)
    assert type(plane.element.radius * 2) is float


def test_unit_says_how_a_stiffness_is_given(plane, solid):
    assert plane.contact.stiffness_kind == plane.bond.stiffness_kind == "total"
    assert solid.contact.stiffness_kind == solid.bond.stiffness_kind == "modulus"
    per_area = {"bond.normal_stiffness": "2.5 GPa/mm", "bond.shear_stiffness": "1e12 Pa/m"}
    changed = plane.with_overrides(per_area)
    assert changed.bond.stiffness_kind == "area" and changed.bond.normal_stiffness == 2.5e12


def test_defaults(solid):
    solid = solid.with_overrides({"crush.peak_drop": None, "crush.record_interval": None})
    assert solid.thickness is None
    assert solid.bond.radius_ratio == solid.bond.moment_contribution == 1.0
    assert solid.bond.friction_angle == 0.0 and solid.bond.grain_scatter is None
    assert solid.agglomerate.leftover == "single" and solid.agglomerate.stamp_share == 1.0
    assert solid.agglomerate.stamp_split is False and solid.agglomerate.random_orientation is True
    assert solid.agglomerate.missing_fraction == 0.0
    assert solid.crush.control == "speed" and solid.crush.peak_drop == 0.5
    assert solid.crush.damping == 0.2 and solid.crush.time_step_safety == 0.5
    assert solid.crush.max_strain == 0.2 and solid.crush.record_interval == 1e-4
    assert solid.crush.platen_stiffness is None


def test_platens_are_as_rough_as_the_elements_unless_told(plane):
    assert plane.crush.platen_friction == plane.contact.friction_coefficient
    assert plane.with_overrides({"contact.friction_coefficient": 0.3}).crush.platen_friction == 0.3
    assert plane.with_overrides({"crush.platen_friction": 0}).crush.platen_friction == 0.0


def test_contact_bond_needs_forces_only(plane):
    card = plane.with_overrides(
        {
            "bond": {"kind": "contact", "tensile_strength": "1 kN", "shear_strength": "2 kN"},
            "bond.friction_angle": "30 deg",
        }
    )
    assert card.bond.tensile_strength == 1000.0 and card.bond.shear_strength == 2000.0
    assert card.bond.friction_angle == pytest.approx(math.pi / 6, rel=1e-15)
    assert card.bond.stiffness_kind is None and card.bond.radius_ratio is None


def test_bond_of_kind_none_needs_nothing(plane):
    card = plane.with_overrides({"bond": {"kind": "none"}})
    assert card.bond.tensile_strength is None and card.bond.scatter.kind == "none"


def test_scatter(plane):
    scatter = {
        "bond.scatter": {"kind": "normal", "coefficient_of_variation": 0.3},
        "bond.grain_scatter": {"modulus": 3, "reference_diameter": "2 cm"},
    }
    card = plane.with_overrides(scatter)
    assert card.bond.scatter.coefficient_of_variation == 0.3 and card.bond.scatter.modulus is None
    assert card.bond.grain_scatter.modulus == 3.0
    assert card.bond.grain_scatter.reference_diameter == 0.02


def test_force_control(plane):
    card = plane.with_overrides({"crush.control": "force", "crush.force_rate": "1.5 MN/s"})
    assert card.crush.force_rate == 1.5e6


def test_to_dict_makes_an_equal_card(plane, solid):
    for card in (plane, solid):
        again = Card.from_dict(card.to_dict())
        assert again == card and hash(again) == hash(card)
        assert again.to_dict() == card.to_dict()
        assert again.content_hash() == card.content_hash()
    assert plane != solid


def test_copies_and_pickles_are_equal_and_remember_where_they_came_from(plane):
    for other in (copy.copy(plane), copy.deepcopy(plane), pickle.loads(pickle.dumps(plane))):
        assert other == plane and other.source == plane.source and other.written == plane.written
        assert other.element.radius.unit == "m"
        assert other.with_overrides({"seed": 2}).seed == 2


def test_card_cannot_be_changed(plane):
    with pytest.raises((TypeError, ValueError)):
        plane.seed = 2
    with pytest.raises((TypeError, ValueError)):
        plane.element.radius = 1.0
    plane.written["seed"] = 5
    assert plane.written["seed"] == 1


def test_card_does_not_follow_the_dictionary_it_was_made_of(written):
    card = Card.from_dict(written)
    written["element"]["radius"] = "1 mm"
    assert card.with_overrides({"seed": 3}).element.radius == 0.0006


def test_overrides_leave_the_card_alone(plane):
    before = plane.to_dict()
    assert plane.with_overrides({"bond.tensile_strength": "2 MPa"}).bond.tensile_strength == 2e6
    assert plane.to_dict() == before


def test_override_with_none_takes_a_key_out(plane):
    none = {"agglomerate.stamp_radius": None, "agglomerate.stamp_deviation": None}
    assert plane.with_overrides(none).agglomerate.stamp_radius is None
    assert plane.with_overrides({"bond.grain_scatter.modulus": None}) == plane


def test_refused_override_names_the_key(plane, refusal):
    assert 'bond.tensile_strength = "2 m": ' in refusal(
        plane.with_overrides, {"bond.tensile_strength": "2 m"}
    )
    assert "bond.tensile_strngth" in refusal(
        plane.with_overrides, {"bond.tensile_strngth": "2 MPa"}
    )
    assert "name is not a table" in refusal(plane.with_overrides, {"name.first": "a"})
    assert "not text" in refusal(plane.with_overrides, {3: "a"})


def test_explain_shows_values_in_si_and_as_written(plane):
    text = plane.explain()
    assert '0.0006 m   (written "0.6 mm")' in text
    assert "end_drop                 = 0.9   (not written)" in text
    for name in ("[bond.grain_scatter]", "platen_stiffness", "allowed:", "default:"):
        assert name in text
    assert max(map(len, text.splitlines())) < 180


def test_explain_without_a_card_shows_every_key(plane):
    schema, of_a_card = Card.explain_schema(), plane.explain()
    assert "0.0006" not in schema
    assert [line for line in of_a_card.splitlines() if line.startswith(("[", " "))] == [
        line for line in schema.splitlines() if line.startswith(("[", " "))
    ]
