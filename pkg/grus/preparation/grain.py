"""Grains of a given diameter, which they have when they are measured."""

from dataclasses import replace

from grus.card import Card
from grus.preparation.width import mean_width, outline_mean_width
from grus.specimen import Outline, Specimen, agglomerate
from grus.specimen.from_card import outline_from_card, stamp_from_card

TRIALS = 4
"""Outlines tried for a grain; elements come and go as a whole, so more would gain nothing."""


def sized_grain(card: Card, number: int, diameter: float) -> Specimen:
    """Grain `number` of the card, as wide as its outline at the equivalent `diameter` [m].

    Elements that lie wholly inside an outline fall short of it by about half a radius all around, so the outline that
    is filled is chosen somewhat larger: such that the mean width of the elements is that of the outline of the given
    diameter. `grain_diameter` is the given one. Raises GrusError when no element fits.
    """
    shape = outline_from_card(card)
    wanted = diameter * outline_mean_width(shape) / shape.equivalent_diameter
    size, best = diameter, None
    for _ in range(TRIALS):
        trial = _filled(card, number, shape.of_diameter(size), stamped=False)
        excess = mean_width(trial.position, card.element.radius, card.dimension) - wanted
        if best is None or abs(excess) < abs(best[0]):
            best = excess, size
        size -= excess * diameter / wanted
    grain = _filled(card, number, shape.of_diameter(best[1]), stamped=True)
    return replace(grain, grain_diameter=[diameter])


def _filled(card: Card, number: int, outline: Outline, stamped: bool) -> Specimen:
    return agglomerate(
        outline,
        card.element.radius,
        stamp=stamp_from_card(card) if stamped else None,
        missing=card.agglomerate.missing_fraction,
        seed=card.seed,
        grain=number,
        thickness=card.thickness or 1.0,
        random_orientation=card.agglomerate.random_orientation,
    )
