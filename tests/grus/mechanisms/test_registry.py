"""The list of mechanisms, and what each makes of a card."""

from pathlib import Path

import pint
import pytest

from grus.card import Card
from grus.errors import GrusError
from grus.mechanisms import MECHANISMS, Mechanism

ROOT = Path(__file__).resolve().parents[3]
STAGES = [
    "load to 100 kPa in 1 h",
    "hold for 4 h",
    "load to 200 kPa",
    "hold for 10 h",
    "unload to 50 kPa",
]


@pytest.fixture(scope="module")
def card() -> Card:
    return Card.from_file(ROOT / "models" / "quick.toml").with_overrides(
        {"oedometer.stages": STAGES}
    )


@pytest.fixture(params=MECHANISMS)
def mechanism(request) -> Mechanism:
    return MECHANISMS[request.param]


def test_every_file_is_a_mechanism_of_its_name():
    folder = ROOT / "pkg" / "grus" / "mechanisms"
    files = {path.stem for path in folder.glob("*.py")} - {"__init__", "mechanism"}
    assert files == set(MECHANISMS)
    assert list(MECHANISMS)[:3] == ["bond_ageing", "wall_friction", "platen_compliance"]


def test_parameters_are_sound(mechanism):
    assert mechanism.acts_on in ("bond", "contact", "test", "instrument")
    assert 1 <= len(mechanism.parameters) <= 3
    for one in mechanism.parameters:
        assert one.unit == "1" or pint.Quantity(1, one.unit).to_base_units().magnitude == 1
        assert 1 <= len(one.sizes) <= 3 and one.low < one.high
        for size in one.sizes:
            one.check(size, mechanism.name)
        assert not one.logarithmic or (one.low > 0 and min(one.sizes) > 0)


def test_page_exists(mechanism):
    assert (ROOT / "docs" / f"{mechanism.page}.md").exists()


def test_acts_on_the_card_or_on_the_record(mechanism, card):
    changed = mechanism.apply(card, {})
    of_record = mechanism.name in ("platen_compliance", "instrument_drift")
    assert (changed.content_hash() == card.content_hash()) == of_record
    assert changed.oedometer.stages[0] == card.oedometer.stages[0]


def test_each_size_is_another_card(mechanism, card):
    first = mechanism.parameters[0]
    cards = {mechanism.apply(card, {first.name: size}).content_hash() for size in first.sizes}
    assert len(cards) in (1, len(first.sizes))


def test_values_are_checked(mechanism, card):
    one = mechanism.parameters[0]
    with pytest.raises(
        GrusError, match=f"{mechanism.name}.{one.name} = .*: out of bounds; allowed"
    ):
        mechanism.apply(card, {one.name: 2 * one.high + 1})
    with pytest.raises(
        GrusError, match=f"{mechanism.name}.colour: no such parameter; allowed: {one.name}"
    ):
        mechanism.apply(card, {"colour": 1.0})


def test_values_arrive(card):
    def of(name: str, **values: float) -> Card:
        return MECHANISMS[name].apply(card, values)

    aged = of("bond_ageing", reference_time=7.5, exponent=30).ageing
    assert (aged.law, aged.reference_time, aged.exponent) == ("power", 7.5, 30)
    rough = of("wall_friction", coefficient=0.2).oedometer
    assert (rough.wall_friction, rough.platens) == (0.2, "top")
    scatter = of("strength_scatter", coefficient_of_variation=0.3).bond.scatter
    assert (scatter.kind, scatter.coefficient_of_variation) == ("normal", 0.3)
    assert of("strength_scatter", coefficient_of_variation=0) == card
    fast = of("loading_too_fast", speed=0.7).oedometer
    assert (fast.speed, fast.fast_speed) == (0.7, None)


def test_wetting_takes_the_hold_at_the_highest_stress_the_time_or_its_own_stage(card):
    wetting = MECHANISMS["wetting_collapse"]
    found = wetting.apply(card, {"strength_factor": 0.8}).wetting
    assert (found.strength_factor, found.time) == (0.8, (1 + 4 + 5) * 3600)
    assert wetting.apply(card, {"time": 7200.0}).wetting.time == 7200
    bare = card.with_overrides({"oedometer.stages": ["load to 100 kPa", "unload to 50 kPa"]})
    stages = wetting.apply(bare, {}).oedometer.stages
    assert [one.kind for one in stages] == ["load", "wet", "unload"]
    own = card.with_overrides(
        {"oedometer.stages": [*STAGES[:1], "wet", *STAGES[1:]], "wetting.strength_factor": 1}
    )
    changed = wetting.apply(own, {"strength_factor": 0.8})
    assert changed.wetting.time is None and changed.oedometer == own.oedometer


def test_a_law_that_was_there_is_replaced(card):
    corroding = {"law": "corrosion", "beta1": "1e-15 m/s", "beta2": 30, "threshold": "10 kPa"}
    aged = MECHANISMS["bond_ageing"].apply(card.with_overrides({"ageing": corroding}), {})
    assert aged.ageing.law == "power" and aged.ageing.threshold == 10e3


def test_hertz_meets_the_linear_contact_at_its_stress(card):
    """Overlap of both under the force of the stress, in the plane and in space."""
    hertz = MECHANISMS["hertzian_contact"]
    space = Card.from_file(ROOT / "models" / "quick-3d.toml")
    for one in (card, space):
        made = hertz.apply(one, {"stress": 2e5, "poisson_ratio": 0.2}).contact
        assert (made.law, made.poisson_ratio) == ("hertz", 0.2)
        radius, diameter = one.element.radius, one.agglomerate.diameter
        force = 2e5 * diameter * (diameter if one.dimension == 3 else one.thickness)
        stiffness = one.contact.normal_stiffness * (1 if one.dimension == 2 else 2 * radius) / 2
        effective = made.young_modulus / (2 * (1 - 0.2**2))
        assert 4 / 3 * effective * (radius / 2) ** 0.5 * (
            force / stiffness
        ) ** 1.5 == pytest.approx(force)


def test_contact_options_arrive(card):
    plastic = MECHANISMS["contact_plasticity"].apply(card, {"unloading_ratio": 3}).contact
    assert plastic.unloading_ratio == 3
    rolling = MECHANISMS["rolling_resistance"].apply(card, {"rolling_friction": 0.2}).contact
    assert (rolling.rolling_friction, rolling.rolling_stiffness) == (0.2, 1.0)
