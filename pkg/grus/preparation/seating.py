"""Seating: bonded grains with final stiffness and friction are brought to rest under the seating stress."""

from dataclasses import replace

import numpy as np
from yade import O

from grus.card import Card
from grus.errors import GrusError
from grus.preparation.prepared import PreparedSpecimen
from grus.preparation.press import Press
from grus.preparation.rigid import fit_rigid
from grus.preparation.walls import wall_box
from grus.scene import grain_material
from grus.specimen import Specimen

STRONG = 1e9
"""Strength of bonds until the specimen is at rest, [Pa] or [N]."""
PROOF = 500
"""Time steps with the final strengths."""


def seat(card: Card, grains: Specimen, corners: np.ndarray, key: str) -> PreparedSpecimen:
    """Brings grains in a box with corners (2, dimension) [m] to rest, with very strong bonds, and proves that none breaks.

    Raises GrusError when a bond breaks, with those strengths or, at the end, with the final ones.
    """
    p = card.preparation
    material = grain_material(card)
    final = material.tensileStrength, material.shearStrength
    strong = STRONG if p.bond_strength is None else float(p.bond_strength)
    if card.bond.kind != "none":
        material.tensileStrength = material.shearStrength = strong
    press = Press(card, grains, corners, material, p.seating_speed)
    press.bond()
    press.engines.quench()
    press.to_rest()
    _refuse_breaks(press, f"preparation.bond_strength = {strong:g}")
    for contact in O.interactions:
        if contact.phys.bonded:
            contact.phys.tensileStrength = final[0] * contact.phys.strengthFactor
            contact.phys.shearStrength = final[1] * contact.phys.strengthFactor
    press.engines.run(PROOF)
    _refuse_breaks(press, f"preparation.seating_stress = {p.seating_stress:g}")
    bonded = [contact.phys for contact in O.interactions if contact.phys.bonded]
    lower, upper = wall_box(press.walls)
    servo = press.servo
    return PreparedSpecimen(
        specimen=replace(grains, position=fit_rigid(grains, press.positions())),
        lower=lower,
        upper=upper,
        axial_stress=(servo.topStress + servo.bottomStress) / 2,
        side_stress=servo.sideStress,
        unbalanced=servo.unbalanced,
        largest_tension=max((phys.tension() for phys in bonded), default=0.0),
        largest_shear=max((phys.shear() for phys in bonded), default=0.0),
        key=key,
    )


def _refuse_breaks(press: Press, what: str) -> None:
    breaks = press.engines.ledger.breaks
    if breaks:
        raise GrusError(
            f"{press.card.source}: {what}: {breaks} bonds broke before the test; allowed: none"
        )
