"""Options of the contact in a card, and how the engines get them."""

import pytest

from grus.card import Card
from grus.errors import GrusError

HERTZ = {"contact.law": "hertz", "contact.young_modulus": "70 GPa", "contact.poisson_ratio": 0.25}
CONTACT_BOND = {
    "bond": {"kind": "contact", "tensile_strength": "1 kN", "shear_strength": "2 kN"},
}


def test_all_are_off_by_default(plane):
    contact = plane.contact
    assert (contact.law, contact.young_modulus, contact.poisson_ratio) == ("linear", None, None)
    assert (contact.unloading_ratio, contact.rolling_friction, contact.rolling_stiffness) == (
        1,
        0,
        0,
    )


@pytest.mark.parametrize("stiffness", ["3e9 N/m", "1 GPa"])
def test_reach_the_material_of_elements(plane, stiffness):
    from grus.scene.material import grain_material, platen_material

    rolling = {"contact.rolling_friction": 0.2, "contact.rolling_stiffness": 0.5}
    linear = {"contact.normal_stiffness": stiffness, "contact.shear_stiffness": stiffness}
    card = plane.with_overrides({**linear, **HERTZ, **rolling})
    material = grain_material(card)
    assert (material.contactLaw, material.young, material.poisson) == ("hertz", 70e9, 0.25)
    assert (material.rollingFriction, material.rollingStiffness) == (0.2, 0.5)
    total = 3e9 if "N/m" in stiffness else 2 * 1e9 * card.element.radius
    assert material.kn == material.ks == pytest.approx(total)
    platen = platen_material(card)
    assert (platen.contactLaw, platen.rollingFriction) == ("linear", 0.2)
    yielding = grain_material(plane.with_overrides({"contact.unloading_ratio": 4}))
    assert (yielding.contactLaw, yielding.unloadingRatio) == ("linear", 4)


@pytest.mark.parametrize(
    "overrides, message",
    [
        (
            {"contact.law": "mindlin"},
            'contact.law = "mindlin": not one of the choices; allowed: "linear" or',
        ),
        ({"contact.law": "hertz"}, "contact.young_modulus: is missing, law hertz needs it"),
        (
            {"contact.young_modulus": "70 GPa"},
            'contact.young_modulus = "70 GPa": law linear has no use',
        ),
        ({**HERTZ, "contact.poisson_ratio": 0.6}, "contact.poisson_ratio = 0.6: out of bounds"),
        ({**HERTZ, "contact.young_modulus": "1 N/m"}, 'contact.young_modulus = "1 N/m": '),
        (
            {**HERTZ, "contact.unloading_ratio": 2},
            "contact.unloading_ratio = 2: not with law hertz",
        ),
        ({"contact.unloading_ratio": 0.9}, "contact.unloading_ratio = 0.9: out of bounds"),
        ({"contact.rolling_friction": -1}, "contact.rolling_friction = -1: out of bounds"),
        ({"contact.rolling_friction": 0.1}, "contact.rolling_stiffness: the other one is not 0"),
        ({"contact.rolling_stiffness": 0.1}, "contact.rolling_friction: the other one is not 0"),
        (
            {**HERTZ, "crush.platen_stiffness": "1e9 N/m"},
            'crush.platen_stiffness = "1e9 N/m": contact.law',
        ),
        ({**HERTZ, **CONTACT_BOND}, 'contact.law = "hertz": not with contact bonds'),
        (
            {"contact.unloading_ratio": 2, **CONTACT_BOND},
            "contact.unloading_ratio = 2: not with contact bonds",
        ),
    ],
)
def test_bad_options_are_told_in_one_line(plane, overrides, message):
    with pytest.raises(GrusError) as refusal:
        plane.with_overrides(overrides)
    lines = str(refusal.value).splitlines()
    assert any(message in line for line in lines), lines


def test_hertz_walls_of_an_oedometer_are_rigid(models):
    card = Card.from_file(models / "quick.toml")
    with pytest.raises(GrusError, match="oedometer.wall_stiffness = .*: contact.law hertz has no"):
        card.with_overrides({**HERTZ, "oedometer.wall_stiffness": "1e9 N/m"})
