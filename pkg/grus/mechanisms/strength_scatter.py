"""Scatter of strength from bond to bond."""

from grus.card import Card
from grus.errors import GrusError
from grus.mechanisms.mechanism import Mechanism, Parameter, Values


def _apply(card: Card, values: Values) -> Card:
    if card.bond.scatter.kind == "weibull":
        raise GrusError(
            f'{card.source}: bond.scatter.kind = "weibull": the bonds scatter already; allowed: "none" or "normal"'
        )
    scatter = values["coefficient_of_variation"]
    if scatter == 0:
        return card.with_overrides({"bond.scatter": None})
    return card.with_overrides(
        {"bond.scatter": {"kind": "normal", "coefficient_of_variation": scatter}}
    )


MECHANISM = Mechanism(
    name="strength_scatter",
    title="Scatter of bond strength",
    acts_on="bond",
    parameters=(
        Parameter(
            "coefficient_of_variation",
            "1",
            low=0.0,
            high=0.5,
            sizes=(0.1, 0.2, 0.3),
            logarithmic=False,
            meaning="Standard deviation over mean of the strength factor of a bond (normal law, cut off at 0 and 2).",
            off=0.0,
        ),
    ),
    summary="Some of the cement is weaker than the rest, so that breakage begins at lower stress and comes little by little instead of "
    "at once.",
    signs="Acoustic events and a bend of the compression curve at low stress, spread over a wide range of stresses; no drift in holds.",
    on_card=_apply,
)
