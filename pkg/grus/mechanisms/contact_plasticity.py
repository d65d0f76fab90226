"""Asperities that yield where grains touch."""

from grus.card import Card
from grus.errors import GrusError
from grus.mechanisms.mechanism import Mechanism, Parameter, Values


def _apply(card: Card, values: Values) -> Card:
    if card.contact.law == "hertz":
        raise GrusError(
            f'{card.source}: contact.law = "hertz": asperities that yield need linear contacts; allowed: "linear"'
        )
    return card.with_overrides({"contact.unloading_ratio": values["unloading_ratio"]})


MECHANISM = Mechanism(
    name="contact_plasticity",
    title="Plasticity of contacts",
    acts_on="contact",
    parameters=(
        Parameter(
            "unloading_ratio",
            "1",
            low=1.0,
            high=100.0,
            sizes=(1.5, 3.0, 10.0),
            logarithmic=True,
            meaning="Normal stiffness of a contact that is unloaded or reloaded, over that of first loading.",
            off=1.0,
        ),
    ),
    summary="The tips of grains are crushed where they touch, so that contacts do not spring back: first loading stays as it is, "
    "unloading and reloading are stiffer and the strain that remains is larger.",
    signs="Steeper unloading and reloading at any stress, also below the stress at which grains break, without acoustic events; "
    "nothing in holds.",
    on_card=_apply,
)
