"""Bonds the elements of each grain."""

from yade import O

from grus.errors import GrusError
from grus.scene.loop import InteractionEngines
from grus.specimen import Specimen

# Of the sum of the radii; pairs that do not touch within Ip2's tolerance stay unbonded.
REACH = 1.01


def bond(specimen: Specimen, engines: InteractionEngines) -> int:
    """Runs one step in which every pair of `specimen.bonds()` is bonded without force; returns their number.

    Call it once, with the engines in `O.engines` and before anything has moved.
    Raises GrusError when YADE did not find the same bonds as the specimen has.
    """
    expected = len(specimen.bonds()) if _has_bonds() else 0
    dt, O.dt = O.dt, 0
    engines.reach(REACH)
    engines.ip2.bonding = True
    O.step()
    engines.ip2.bonding = False
    engines.reach(1)
    O.dt = dt
    made = sum(i.phys.bonded for i in O.interactions)
    if made != expected:
        raise GrusError(f"bonds made = {made}; the specimen has {expected}")
    return made


def _has_bonds() -> bool:
    """Whether any material of the scene is one of bonded grains."""
    return any(getattr(material, "bond", "none") != "none" for material in O.materials)
