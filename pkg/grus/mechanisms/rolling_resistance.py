"""Elements that resist rolling on each other."""

from grus.card import Card
from grus.mechanisms.mechanism import Mechanism, Parameter, Values


def _apply(card: Card, values: Values) -> Card:
    off = values["rolling_friction"] == 0
    return card.with_overrides(
        {
            "contact.rolling_friction": values["rolling_friction"],
            "contact.rolling_stiffness": 0 if off else values["rolling_stiffness"],
        }
    )


MECHANISM = Mechanism(
    name="rolling_resistance",
    title="Rolling resistance",
    acts_on="contact",
    parameters=(
        Parameter(
            "rolling_friction",
            "1",
            low=0.0,
            high=5.0,
            sizes=(0.05, 0.2, 1.0),
            logarithmic=False,
            meaning="Largest moment that resists rolling, over normal force and radius of an element.",
            off=0.0,
        ),
        Parameter(
            "rolling_stiffness",
            "1",
            low=0.01,
            high=20.0,
            sizes=(1.0,),
            logarithmic=True,
            meaning="Stiffness against rolling, over shear stiffness and both radii.",
        ),
    ),
    summary="Grains touch in small areas instead of points, which keeps them from rolling over each other, so that the specimen "
    "rearranges less.",
    signs="Stiffer first loading and unloading, a lower lateral stress and fewer sudden settlements, as with stronger cement or more "
    "friction; nothing in holds.",
    on_card=_apply,
)
