"""Platens that close too fast for the specimen to follow at rest."""

from grus.card import Card
from grus.mechanisms.mechanism import Mechanism, Parameter, Values


def _apply(card: Card, values: Values) -> Card:
    return card.with_overrides(
        {"oedometer.speed": f"{values['speed']!r} m/s", "oedometer.fast_speed": None}
    )


MECHANISM = Mechanism(
    name="loading_too_fast",
    title="Loading too fast",
    acts_on="test",
    parameters=(
        Parameter(
            "speed",
            "m/s",
            low=1e-3,
            high=5.0,
            sizes=(0.1, 0.4, 1.5),
            logarithmic=True,
            meaning="Largest speed of each platen.",
        ),
    ),
    summary="The load comes faster than the specimen can follow: inertia carries a part of it, and platens overshoot. A fault of the run, not "
    "of nature.",
    signs="Different stresses on top and base during loading though the walls are smooth, overshoot at the end of a load, breakage "
    "that begins at higher stress; an inertial number above 0.001.",
    on_card=_apply,
)
