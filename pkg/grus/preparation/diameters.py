"""Number and diameters of the grains that a card asks for."""

import numpy as np

from grus.card import Card
from grus.errors import GrusError
from grus.grading import Grading, power_law_of_rms, sample_diameters
from grus.grading.numbers import UNIT_MEASURE
from grus.preparation.stream import Step, stream
from grus.specimen.rounding import on_grid

HEIGHT_TOLERANCE = 0.05
"""Largest difference between the height of the card and that which the grains need, over the former [-]."""
FEWEST = 4


def grading(card: Card) -> Grading:
    """Grading by mass of the card's specimen."""
    s = card.specimen
    if s.sieve is not None:
        return Grading(np.array(s.sieve, dtype=float), np.array(s.passing))
    return power_law_of_rms(s.minimum_diameter, s.maximum_diameter, s.rms_diameter, card.dimension)


def base(card: Card) -> np.ndarray:
    """Breadths (dimension - 1,) of the box across the axis of loading [m]."""
    s = card.specimen
    return np.array([s.width] if card.dimension == 2 else [s.width, s.depth], dtype=float)


def diameters(card: Card) -> np.ndarray:
    """Diameters (n,) of the grains [m].

    Raises GrusError when the box holds fewer than four grains, or when the card's number of grains would stand more
    than 5 % higher or lower than its height at its void ratio.
    """
    s = card.specimen
    solids = float(base(card).prod()) * s.height / (1 + s.void_ratio)
    curve = grading(card)
    generator = stream(card.seed, Step.DIAMETERS)
    if s.grains is None:
        sampled = sample_diameters(curve, card.dimension, generator, measure=solids)
    else:
        sampled = sample_diameters(curve, card.dimension, generator, count=s.grains)
    if len(sampled) < FEWEST:
        raise GrusError(
            f"{card.source}: specimen: the box holds {len(sampled)} grains at void ratio {s.void_ratio:g}; "
            f"allowed: {FEWEST} or more"
        )
    share = UNIT_MEASURE[card.dimension] * (sampled**card.dimension).sum() / solids
    if abs(share - 1) > HEIGHT_TOLERANCE:
        fit = round(len(sampled) / share)
        raise GrusError(
            f"{card.source}: specimen.grains = {len(sampled)}: at void ratio {s.void_ratio:g} they stand "
            f"{share * s.height:.4g} m high, not {s.height:g} m; allowed: about {fit}, or leave the key out"
        )
    return on_grid(sampled, card.element.radius)
