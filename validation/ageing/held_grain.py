"""One grain under a constant platen force until it gives way."""

from dataclasses import dataclass

import grus  # noqa: F401  first, since it loads YADE
from yade import O
from yade.wrapper import BondAgeing, OedometerServo

from grus.card import Card
from grus.crushing import CrushingTest
from grus.specimen import Specimen

GIVES_WAY = 1.5
"""Closing, over that of the sound grain under the same force, at which a grain counts as crushed."""
SLICE = 5000
"""Time steps between two looks."""
MOST = 500_000
"""Time steps after which a test is given up."""


@dataclass(frozen=True)
class Life:
    """Life [s] of a grain under a stress [Pa]; 0 when it was crushed before the stress was reached, None when it lived on.

    failures: delayed failures of bonds up to then. steps: time steps of the whole test.
    """

    stress: float
    life: float | None
    failures: int
    steps: int


def hold_grain(
    card: Card, grain: int, stress: float, specimen: Specimen | None = None, **law: object
) -> Life:
    """Loads a grain to force over diameter and thickness = `stress` [Pa] and holds it until it gives way.

    The servo of the oedometer keeps the force on both platens: an area of diameter times thickness makes its stress the
    one that crushing strengths are told in. specimen: another grain than the card's own. law: parameters of
    BondAgeing.
    """
    test = CrushingTest(card, grain, specimen)
    platens = test.platens
    diameter = card.agglomerate.diameter
    servo = OedometerServo(
        bottom=platens.bottom,
        top=platens.top,
        axis=platens.axis,
        area=diameter * card.thickness,
        solidVolume=diameter**2 * card.thickness,
        ledger=test.engines.ledger,
        maxSpeed=0.01,
        tolerance=1e-3,
        unbalancedLimit=1e-4,
        quietSteps=500,
        quietStretches=1,
    )
    ageing = BondAgeing(servo=servo, ledger=servo.ledger, **law)
    test.engines.start([servo])
    O.engines = O.engines + [ageing]
    servo.begin(stress)
    while not servo.done:
        O.run(SLICE, True)
        if servo.strain > 0.01 or O.iter > MOST:
            return Life(stress, 0.0, 0, O.iter)
    sound = servo.strain
    ageing.hold(1e60)
    while ageing.holding and O.iter < MOST:
        O.run(SLICE, True)
        records = zip(ageing.recordClock, ageing.recordHeight, ageing.recordFailures)
        for clock, height, failures in records:
            if servo.initialHeight - height > GIVES_WAY * sound * servo.initialHeight:
                return Life(stress, clock, failures, O.iter)
        if servo.strain > 0.05:
            return Life(stress, ageing.clock, ageing.failures, O.iter)
    return Life(stress, None, ageing.failures, O.iter)
