"""The order of O.interactions is one of history. The time step may not depend on it: a loaded scene has another history."""

from scenes import MODELS, engine
from yade import O
from yade.wrapper import BondTimeStepper, InteractionSorter

import grus
from grus.crushing import CrushingTest


def order() -> list[tuple[int, int]]:
    return [(one.id1, one.id2) for one in O.interactions]


def test_critical_step_does_not_depend_on_the_order_of_contacts():
    test = CrushingTest(grus.Card.from_file(MODELS.parent / "tests" / "cards" / "plane.toml"))
    while test.engines.ledger.breaks < 20:
        O.run(1000, True)
    before, critical = order(), engine(BondTimeStepper).critical()
    InteractionSorter()()
    assert order() != before and sorted(order()) == sorted(before)
    assert engine(BondTimeStepper).critical() == critical
