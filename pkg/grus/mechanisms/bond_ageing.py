"""Static fatigue of bonds."""

from grus.card import Card
from grus.mechanisms.mechanism import Mechanism, Parameter, Values


def _apply(card: Card, values: Values) -> Card:
    return card.with_overrides(
        {
            "ageing.law": "power",
            "ageing.beta1": None,
            "ageing.beta2": None,
            "ageing.exponent": values["exponent"],
            "ageing.reference_time": f"{values['reference_time']!r} s",
        }
    )


MECHANISM = Mechanism(
    name="bond_ageing",
    title="Static fatigue of bonds",
    acts_on="bond",
    parameters=(
        Parameter(
            "reference_time",
            "s",
            low=1e-6,
            high=1e9,
            sizes=(1e3, 1.0, 1e-3),
            logarithmic=True,
            meaning="Time t0: a bond under a small constant stress lasts t0/(n + 1) (stress/strength)^-n; shorter is stronger.",
        ),
        Parameter(
            "exponent",
            "1",
            low=5,
            high=100,
            sizes=(20.0, 40.0),
            logarithmic=True,
            meaning="Exponent n of the power law.",
        ),
    ),
    summary="The cement inside the grains loses strength under sustained stress, so that grains go on breaking and the specimen "
    "settles under constant load (creep).",
    signs="Strain that grows about linearly with the logarithm of time in a hold, more under higher stress, and stops after "
    "unloading; acoustic events that go on in the hold.",
    on_card=_apply,
)
