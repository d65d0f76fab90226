"""A contact law in YADE as the verification uses it: material, functors, and whether a bond holds."""

from dataclasses import dataclass, field

import numpy as np
from yade import utils
from yade.wrapper import (
    Bo1_Sphere_Aabb,
    Body,
    BondMat,
    CohFrictMat,
    Engine,
    ForceResetter,
    IGeomFunctor,
    InsertionSortCollider,
    Interaction,
    InteractionLoop,
    IPhysFunctor,
    LawFunctor,
    Material,
)

DENSITY = 2600.0  # [kg/m3]
REACH = 1.0001  # of the sum of the radii: elements that touch are seen whatever the rounding


@dataclass
class Law:
    """Material and functors of one law, for one scene.

    strengths: names of the limits of tension and shear among the attributes of its contacts.
    engines: those that the law needs after the interaction loop.
    """

    material: Material
    geometry: IGeomFunctor
    physics: IPhysFunctor
    law: LawFunctor
    strengths: tuple[str, str]
    engines: list[Engine] = field(default_factory=list)

    def holds(self, interaction: Interaction) -> bool:
        """Whether the bond of a pair holds."""
        if not interaction.isReal:
            return False
        phys = interaction.phys
        if isinstance(self.material, BondMat):
            return phys.bonded
        if isinstance(self.material, CohFrictMat):
            return not phys.cohesionBroken
        return phys.isCohesive

    def sphere(self, centre: np.ndarray, radius: float) -> Body:
        """A body of this material, in the one grain of the scene."""
        body = utils.sphere(centre, radius, material=self.material, color=(1, 1, 1))
        if isinstance(self.material, BondMat):
            body.state.grain = 0
        return body

    def interaction_engines(self) -> list[Engine]:
        """Engines from the reset of forces to the law, which bond all that touches until `born` is called."""
        self.geometry.interactionDetectionFactor = REACH
        return [
            ForceResetter(),
            InsertionSortCollider([Bo1_Sphere_Aabb(aabbEnlargeFactor=REACH)]),
            InteractionLoop([self.geometry], [self.physics], [self.law]),
            *self.engines,
        ]

    def born(self) -> None:
        """To be called after the first step: contacts that form later are not bonded."""
        self.geometry.interactionDetectionFactor = 1
        if isinstance(self.material, BondMat):
            self.physics.bonding = False

    def weaken(self, interaction: Interaction, factor: float) -> None:
        """Multiplies both limits of one bond."""
        for name in self.strengths:
            setattr(interaction.phys, name, factor * getattr(interaction.phys, name))
