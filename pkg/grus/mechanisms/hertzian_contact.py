"""Contacts that get stiffer as they are pressed together."""

from math import sqrt

from grus.card import Card
from grus.errors import GrusError
from grus.mechanisms.mechanism import Mechanism, Parameter, Values


def matching_modulus(card: Card, stress: float, poisson_ratio: float) -> float:
    """Young's modulus [Pa] whose Hertz contacts of two elements overlap as much as the card's linear ones under `stress` [Pa].

    The mean contact force is taken as the stress times the square of the diameter of a grain, in the plane times diameter
    and thickness. From F = 4/3 E* root(R*) u^(3/2) with E* = E / (2 (1 - nu^2)) and R* = R / 2.
    """
    diameter, radius = card.agglomerate.diameter, card.element.radius
    force = stress * diameter * (card.thickness if card.dimension == 2 else diameter)
    own = card.contact.normal_stiffness
    element = own if card.contact.stiffness_kind == "total" else 2 * own * radius
    overlap = force / (element / 2)
    effective = 0.75 * force / (sqrt(radius / 2) * overlap**1.5)
    return float(2 * (1 - poisson_ratio**2) * effective)


def _apply(card: Card, values: Values) -> Card:
    if card.contact.unloading_ratio != 1:
        raise GrusError(
            f"{card.source}: contact.unloading_ratio = {card.contact.unloading_ratio:g}: asperities that yield need linear "
            "contacts; allowed: 1"
        )
    modulus = matching_modulus(card, values["stress"], values["poisson_ratio"])
    return card.with_overrides(
        {
            "contact.law": "hertz",
            "contact.young_modulus": f"{modulus!r} Pa",
            "contact.poisson_ratio": values["poisson_ratio"],
        }
    )


MECHANISM = Mechanism(
    name="hertzian_contact",
    title="Hertz-Mindlin contacts",
    acts_on="contact",
    parameters=(
        Parameter(
            "stress",
            "Pa",
            low=1e3,
            high=1e8,
            sizes=(1e5, 1e6, 1e7),
            logarithmic=True,
            meaning="Axial stress at which contacts overlap as much as the card's linear ones; they are softer below and stiffer above.",
        ),
        Parameter(
            "poisson_ratio",
            "1",
            low=0.0,
            high=0.5,
            sizes=(0.25,),
            logarithmic=False,
            meaning="Poisson's ratio of the elements' solid, which sets the shear stiffness beside the normal one.",
        ),
    ),
    summary="Grains are round where they touch, so that contacts are soft at first and get stiffer as the load grows.",
    signs="A compression curve that is soft at low stress and gets steeper before grains break, and unloading with the same toe; no "
    "acoustic events, nothing in holds.",
    on_card=_apply,
)
