"""The engines that find contacts and compute their forces."""

from yade.wrapper import (
    Bo1_Sphere_Aabb,
    Bo1_Wall_Aabb,
    BondLedger,
    Engine,
    ForceResetter,
    Ig2_Sphere_Sphere_ScGeom,
    Ig2_Wall_Sphere_ScGeom,
    InsertionSortCollider,
    InteractionLoop,
    InteractionSorter,
    Ip2_BondMat_BondMat_BondPhys,
    Law2_ScGeom_BondPhys_Bonded,
)


class InteractionEngines:
    """Collider, interaction loop and ledger of a scene of spheres and walls, in the order that YADE needs.

    `list` holds the engines, to be put first into `O.engines`; the parts that a script may want to reach are
    `ledger`, `law` and `ip2`.
    """

    def __init__(self) -> None:
        self.bound = Bo1_Sphere_Aabb()
        self.sphere_contact = Ig2_Sphere_Sphere_ScGeom()
        self.ip2 = Ip2_BondMat_BondMat_BondPhys()
        self.ledger = BondLedger()
        self.law = Law2_ScGeom_BondPhys_Bonded(ledger=self.ledger)
        self.list: list[Engine] = [
            ForceResetter(),
            InsertionSortCollider([self.bound, Bo1_Wall_Aabb()]),
            InteractionSorter(),
            InteractionLoop(
                [self.sphere_contact, Ig2_Wall_Sphere_ScGeom()], [self.ip2], [self.law]
            ),
            self.ledger,
        ]

    def reach(self, factor: float) -> None:
        """Lets contacts be found at up to `factor` times the sum of the radii (1: only when they touch)."""
        self.bound.aabbEnlargeFactor = factor
        self.sphere_contact.interactionDetectionFactor = factor
