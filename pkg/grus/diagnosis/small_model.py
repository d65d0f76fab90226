"""The model of a card with a small specimen, cheap enough for the many runs of a diagnosis."""

from math import sqrt

from grus.card import Card
from grus.errors import GrusError

GRAINS = 40
ELEMENTS = 22
"""Elements of a grain of mean size, about."""
LOOSE = 0.03
"""Tolerance of the void ratio."""
SLOW = 0.01
"""Speed of the platens [m/s]."""
QUIET = 400
"""Steps at rest that end a stage."""
MOST_STEPS = 2_000_000
"""Steps after which a stage is given up: a specimen that collapses altogether takes many more than any other, and says
nothing. Steps and not seconds, so that a busy machine gives the same verdict."""
DAMPING = 0.2
"""Local damping, at most: more holds back the stress on its way from the top to the base, which is fixed."""
FILLED = 0.8
"""Area of a grain's elements over that of its outline, about."""


def small_model(card: Card) -> Card:
    """The card with about 40 grains of about 22 elements in a box of the same shape, where it has more of either.

    Strengths and stiffnesses of bonds stay as they are: the calibration that follows finds them anew, since both
    numbers change what a grain carries.
    Raises GrusError when the card has no oedometer test.
    """
    for table in ("specimen", "oedometer"):
        if getattr(card, table) is None:
            raise GrusError(f"{card.source}: {table} is missing; allowed: a table [{table}]")
    small = _fewer_grains(_coarser(card))
    return small.with_overrides(
        {
            # Not to be had exactly with few grains; what it scatters by is part of the scatter of specimens.
            "preparation.void_ratio_tolerance": LOOSE,
            # A small specimen comes to rest sooner: waves cross it in some 150 steps.
            "oedometer.quiet_steps": min(card.oedometer.quiet_steps, QUIET),
            "oedometer.max_steps": min(card.oedometer.max_steps, MOST_STEPS),
            # Faster platens would send waves of some ten kPa ahead of them.
            "oedometer.speed": f"{min(float(card.oedometer.speed), SLOW):g} m/s",
            "oedometer.fast_speed": None,
            "oedometer.damping": min(card.oedometer.damping, DAMPING),
        }
    )


def _coarser(card: Card) -> Card:
    if card.dimension == 3:
        return card
    mean = float(card.specimen.rms_diameter or card.agglomerate.diameter) / 2
    radius = mean * sqrt(FILLED / ELEMENTS)
    factor = radius / float(card.element.radius)
    if factor <= 1:
        return card
    changes = {"element.radius": f"{radius:.6g} m"}
    for name in ("stamp_radius", "stamp_deviation"):
        value = getattr(card.agglomerate, name)
        if value is not None:
            changes[f"agglomerate.{name}"] = f"{float(value) * factor:.6g} m"
    return card.with_overrides(changes)


def _fewer_grains(card: Card) -> Card:
    specimen = card.specimen
    now = specimen.grains or _expected_grains(card)
    if now <= GRAINS:
        return card
    scale = (GRAINS / now) ** (1 / card.dimension)
    changes = {
        f"specimen.{name}": f"{float(getattr(specimen, name)) * scale:.6g} m"
        for name in ("width", "height", "depth")
        if getattr(specimen, name, None) is not None
    }
    changes["specimen.grains"] = None
    return card.with_overrides(changes)


def _expected_grains(card: Card) -> float:
    specimen = card.specimen
    mean = float(specimen.rms_diameter or card.agglomerate.diameter)
    box = float(specimen.width) * float(specimen.height)
    one = 0.785 * mean**2
    if card.dimension == 3:
        box *= float(specimen.depth or specimen.width)
        one = 0.524 * mean**3
    return box / one / (1 + specimen.void_ratio)
