"""Collapse on wetting."""

from grus.card import Card
from grus.errors import GrusError
from grus.mechanisms.mechanism import Mechanism, Parameter, Values


def _apply(card: Card, values: Values) -> Card:
    if card.oedometer is None:
        raise GrusError(
            f"{card.source}: oedometer is missing; allowed: a table [oedometer] with stages"
        )
    changes = {"wetting.strength_factor": values["strength_factor"]}
    stages = card.oedometer.stages
    if any(stage.kind == "wet" for stage in stages):
        return card.with_overrides(changes)
    time = values["time"] or _middle_of_hold(stages)
    if time is not None:
        return card.with_overrides(changes | {"wetting.time": f"{time!r} s"})
    words = [stage.written() for stage in stages]
    highest = max(range(len(stages)), key=lambda i: stages[i].stress or 0.0)
    words.insert(highest + 1, "wet")
    return card.with_overrides(changes | {"oedometer.stages": words})


def _middle_of_hold(stages: tuple) -> float | None:
    """Laboratory time in the middle of the first hold at the highest stress [s]; None without one."""
    now, stress, found = 0.0, 0.0, []
    for stage in stages:
        stress = stress if stage.rests else float(stage.stress)
        duration = float(stage.duration or 0.0)
        if stage.kind == "hold":
            found.append((stress, now + duration / 2))
        now += duration
    highest = max(float(stage.stress or 0.0) for stage in stages)
    return next((time for level, time in found if level == highest), None)


MECHANISM = Mechanism(
    name="wetting_collapse",
    title="Collapse on wetting",
    acts_on="bond",
    parameters=(
        Parameter(
            "strength_factor",
            "1",
            low=0.1,
            high=1.0,
            sizes=(0.9, 0.7, 0.5),
            logarithmic=False,
            meaning="Factor on the strengths of all bonds.",
            off=1.0,
        ),
        Parameter(
            "time",
            "s",
            low=0.0,
            high=1e10,
            sizes=(0.0,),
            logarithmic=False,
            meaning='Laboratory time of wetting; 0: in the middle of the first hold at the highest stress. A stage "wet" goes before.',
        ),
    ),
    summary="Water weakens the cement of the grains at one moment, and the specimen settles at once under the stress it is under.",
    signs="A jump of strain at constant stress, with a burst of acoustic events, and a softer specimen in loading from then on.",
    on_card=_apply,
)
