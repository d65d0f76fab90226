"""[specimen] and [preparation]: optional, with defaults, refused when they do not fit the rest."""

import pytest

from grus.card import Card

SPECIMEN = {
    "width": "81 mm",
    "height": "77 mm",
    "void_ratio": 0.25,
    "minimum_diameter": "9.5 mm",
    "maximum_diameter": "19.1 mm",
    "rms_diameter": "12.6 mm",
}
TABLE = {
    "specimen.minimum_diameter": None,
    "specimen.maximum_diameter": None,
    "specimen.rms_diameter": None,
    "specimen.sieve": ["9.5 mm", "12.5 mm", "19 mm"],
    "specimen.passing": [0, 40, 100],
}


@pytest.fixture
def bare(written):
    """A card without a specimen."""
    return {
        name: table for name, table in written.items() if name not in ("specimen", "preparation")
    }


@pytest.fixture
def card(bare):
    return Card.from_dict(bare | {"specimen": SPECIMEN})


def test_both_tables_are_optional(bare):
    card = Card.from_dict(bare)
    assert card.specimen is None and card.preparation is None
    assert "specimen" not in card.to_dict() and "preparation" not in card.to_dict()


def test_a_specimen_brings_a_preparation(card, bare):
    p = card.preparation
    assert (p.seating_stress, p.friction, p.stiffness_growth) == (5e3, 0.0, 100.0)
    assert p.normal_stiffness is None and p.bond_strength is None
    written_out = Card.from_dict(bare | {"specimen": SPECIMEN, "preparation": {"friction": 0}})
    assert written_out.content_hash() == card.content_hash()
    assert Card.from_dict(card.to_dict()) == card


def test_a_grading_by_sieves(card):
    other = card.with_overrides(TABLE)
    assert other.specimen.sieve == (0.0095, 0.0125, 0.019)
    assert other.specimen.passing == (0.0, 40.0, 100.0)
    assert Card.from_dict(other.to_dict()) == other
    assert other.content_hash() != card.content_hash()
    finer = TABLE | {"specimen.sieve": ["0.95 cm", "0.0125 m", "19 mm"]}
    assert card.with_overrides(finer).content_hash() == other.content_hash()


@pytest.mark.parametrize(
    "change, words",
    [
        ({"specimen.void_ratio": 0}, ("specimen.void_ratio = 0", "> 0")),
        ({"specimen.width": "30 mm"}, ("specimen.width", "two of the largest", "0.0382 m")),
        ({"specimen.depth": "80 mm"}, ("specimen.depth", "dimension 2 has no use")),
        ({"specimen.rms_diameter": "9.5 mm"}, ("specimen.rms_diameter", "not well between")),
        ({"specimen.rms_diameter": None}, ("specimen.rms_diameter", "is missing")),
        ({"specimen.maximum_diameter": "9 mm"}, ("specimen.maximum_diameter", "not above")),
        ({"specimen.minimum_diameter": "2 mm"}, ("specimen.minimum_diameter", "elements across")),
        ({"specimen.sieve": ["9 mm", "12 mm"]}, ("specimen.passing", "is missing")),
        (TABLE | {"specimen.passing": [0, 100]}, ("specimen.passing", "2 numbers for 3 sieves")),
        (TABLE | {"specimen.passing": [0, 50, 90]}, ("specimen.passing", "from 0 to 100")),
        (TABLE | {"specimen.passing": [0, "50", 100]}, ("specimen.passing", "sieve 2")),
        (
            TABLE | {"specimen.sieve": ["9.5 mm", "9.5 mm", "19 mm"]},
            ("specimen.sieve", "sieve 2 does not rise"),
        ),
        (TABLE | {"specimen.sieve": "9.5 mm"}, ("specimen.sieve", "not a list")),
        (TABLE | {"specimen.rms_diameter": "12 mm"}, ("specimen.rms_diameter", "no use for it")),
        ({"specimen.grains": 0}, ("specimen.grains = 0", "from 1")),
        ({"specimen": None, "preparation.friction": 0}, ("preparation", "without [specimen]")),
        ({"preparation.bond_strength": "1 kN"}, ("preparation.bond_strength", "needs a stress")),
        (
            {"preparation.normal_stiffness": "1 GPa", "preparation.wall_stiffness": "1 N/m"},
            ("preparation.wall_stiffness", "same way"),
        ),
        ({"preparation.start_factor": 1}, ("preparation.start_factor = 1", "< 1")),
    ],
)
def test_what_does_not_fit_is_refused(card, refusal, change, words):
    message = refusal(card.with_overrides, change)
    assert all(word in message for word in words)


def test_space_needs_a_depth(solid, refusal):
    message = refusal(solid.with_overrides, {"specimen": SPECIMEN})
    assert "specimen.depth" in message and "dimension 3 needs it" in message
    assert solid.with_overrides({"specimen": SPECIMEN | {"depth": "80 mm"}}).specimen.depth == 0.08
