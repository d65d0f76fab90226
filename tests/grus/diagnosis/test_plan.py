"""What is looked for."""

from pathlib import Path

from formula import made_test

from grus.card import Card
from grus.diagnosis.plan import directions
from grus.diagnosis.protocol import protocol
from grus.diagnosis.small_model import small_model

QUICK = Path(__file__).resolve().parents[3] / "models" / "quick.toml"


def names(card: Card) -> tuple[set[str], dict[str, str]]:
    wanted, unfit = directions(protocol(made_test()), small_model(card))
    return {one.mechanism.name for one in wanted}, unfit


def test_all_but_wetting_without_a_jump():
    found, unfit = names(Card.from_file(QUICK))
    assert not unfit and "wetting_collapse" not in found
    assert {"bond_ageing", "wall_friction", "platen_compliance", "instrument_drift"} <= found


def test_a_mechanism_that_the_card_has_no_room_for_is_left_out_and_told():
    """Contacts are Hertz's or plastic, not both."""
    card = Card.from_file(QUICK).with_overrides({"contact.unloading_ratio": 2.0})
    found, unfit = names(card)
    assert "hertzian_contact" not in found and "bond_ageing" in found
    assert list(unfit) == ["hertzian_contact"] and unfit["hertzian_contact"]
