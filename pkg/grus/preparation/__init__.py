"""Preparation of an oedometer specimen: exo-spheres grown in a box, grains in their place, brought to rest."""

from grus.preparation.preparation import make, prepare
from grus.preparation.prepared import PreparedSpecimen

__all__ = ["PreparedSpecimen", "make", "prepare"]
