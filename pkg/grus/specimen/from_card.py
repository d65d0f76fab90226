"""Grains as a card describes them."""

import numpy as np

from grus.card import Card
from grus.errors import GrusError
from grus.specimen.agglomerate import agglomerate
from grus.specimen.mesh import Mesh
from grus.specimen.outline import Circle, Outline, Sphere
from grus.specimen.polygon import Polygon
from grus.specimen.specimen import Specimen
from grus.specimen.stamp import Stamp


def outline_from_card(card: Card) -> Outline:
    """Outline of the card's grains, scaled to its diameter. Raises GrusError for a mesh that bounds no body."""
    shape = card.agglomerate
    if shape.outline == "circle":
        return Circle(shape.diameter)
    if shape.outline == "sphere":
        return Sphere(shape.diameter)
    if shape.outline == "polygon":
        return Polygon(np.array(shape.vertices, dtype=float)).of_diameter(shape.diameter)
    try:
        return Mesh.read(card.mesh_path).of_diameter(shape.diameter)
    except GrusError as error:
        raise GrusError(f'{card.source}: agglomerate.mesh = "{shape.mesh}": {error}') from None


def stamp_from_card(card: Card) -> Stamp | None:
    """Stamp of the card's grains; None when each element is a clump of its own."""
    shape = card.agglomerate
    if shape.stamp_radius is None:
        return None
    return Stamp(
        mean=shape.stamp_radius,
        deviation=shape.stamp_deviation,
        share=shape.stamp_share,
        leftover=shape.leftover,
        split=shape.stamp_split,
    )


def grain_from_card(card: Card, grain: int = 0) -> Specimen:
    """Grain number `grain` of the card: the same whenever and wherever it is made."""
    return agglomerate(
        outline_from_card(card),
        card.element.radius,
        stamp=stamp_from_card(card),
        missing=card.agglomerate.missing_fraction,
        seed=card.seed,
        grain=grain,
        thickness=card.thickness or 1.0,
        random_orientation=card.agglomerate.random_orientation,
    )
