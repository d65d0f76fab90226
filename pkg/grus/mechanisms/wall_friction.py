"""Friction between the specimen and the ring."""

from grus.card import Card
from grus.mechanisms.mechanism import Mechanism, Parameter, Values


def _apply(card: Card, values: Values) -> Card:
    return card.with_overrides(
        {"oedometer.wall_friction": values["coefficient"], "oedometer.platens": "top"}
    )


MECHANISM = Mechanism(
    name="wall_friction",
    title="Side-wall friction",
    acts_on="test",
    parameters=(
        Parameter(
            "coefficient",
            "1",
            low=0.0,
            high=1.0,
            sizes=(0.05, 0.15, 0.3),
            logarithmic=False,
            meaning="Coefficient of friction between elements and walls.",
            off=0.0,
        ),
    ),
    summary="The ring, which is fixed, carries a part of the load by friction, so that the base gets less stress than the top and the "
    "specimen seems stiffer.",
    signs="Base stress below top stress in loading and above it after unloading; a smaller strain that recovers less.",
    on_card=_apply,
)
