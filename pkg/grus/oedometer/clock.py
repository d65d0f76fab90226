"""Bonds that change with laboratory time, in the current scene."""

import numpy as np
from yade import O
from yade.wrapper import BondAgeing, OedometerServo

from grus.card import Card
from grus.oedometer.program import Planned
from grus.record import Record

UNITS = {
    "clock": "s",
    "stage": "1",
    "height": "m",
    "top_stress": "Pa",
    "bottom_stress": "Pa",
    "side_stress": "Pa",
    "failures": "1",
    "breaks": "1",
}


def add_ageing(card: Card, servo: OedometerServo) -> None:
    """Puts a BondAgeing last into `O.engines` when the card has [ageing] or [wetting]."""
    if card.ageing is None and card.wetting is None:
        return
    engine = BondAgeing(servo=servo, ledger=servo.ledger, law="none")
    if card.ageing is not None:
        _set_law(engine, card)
    if card.wetting is not None:
        engine.wetFactor = card.wetting.strength_factor
        engine.wetAt = -1 if card.wetting.time is None else card.wetting.time
    O.engines = O.engines + [engine]


def _set_law(engine: BondAgeing, card: Card) -> None:
    law = card.ageing
    engine.law = law.law
    if law.law == "power":
        engine.exponent, engine.referenceTime = law.exponent, law.reference_time
    else:
        engine.beta1, engine.beta2 = law.beta1, law.beta2
    engine.threshold, engine.humidity = law.threshold, law.humidity


def ageing() -> BondAgeing | None:
    """That of the current scene, also of one that was loaded; None where bonds do not change with time."""
    return next((one for one in O.engines if isinstance(one, BondAgeing)), None)


def set_clock(stage: Planned) -> None:
    """Tells the clock what the stage that has just begun is to do with it."""
    engine = ageing()
    if engine is None:
        return
    follows = stage.timed and stage.start != stage.stress
    engine.scheduleStress = [stage.start, stage.stress] if follows else []
    engine.scheduleClock = [stage.begins, stage.ends] if follows else []
    if stage.kind == "hold":
        engine.hold(stage.ends - stage.begins)
    elif stage.kind == "wet":
        engine.clock = stage.ends
        engine.wet(engine.wetFactor)


def rests() -> Record:
    """What the clock of the current scene has recorded: the specimen at rest in holds, and at delayed failures."""
    engine = ageing()
    if engine is None:
        return Record({}, {})
    columns = (
        engine.recordClock,
        engine.recordStage,
        engine.recordHeight,
        engine.recordTop,
        engine.recordBottom,
        engine.recordSide,
        engine.recordFailures,
        engine.recordBreaks,
    )
    return Record(dict(zip(UNITS, map(np.array, columns))), UNITS)
