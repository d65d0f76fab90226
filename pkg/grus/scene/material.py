"""YADE materials from a card."""

from math import atan

from yade.wrapper import BondMat

from grus.card import Card


def grain_material(card: Card) -> BondMat:
    """The material of all elements: contact, bond, strengths and their scatter."""
    bond = card.bond
    material = BondMat(
        label="grain",
        density=card.element.density,
        frictionAngle=atan(card.contact.friction_coefficient),
        thickness=card.thickness if card.dimension == 2 else 0,
        seed=card.seed,
        bond=bond.kind,
        **_contact_stiffness(card),
        **_contact_options(card),
    )
    if bond.kind == "none":
        return material
    material.tensileStrength = bond.tensile_strength
    material.shearStrength = bond.shear_strength
    material.bondFrictionAngle = bond.friction_angle
    if bond.scatter.kind == "normal":
        material.scatterParameter = bond.scatter.coefficient_of_variation
    elif bond.scatter.kind == "weibull":
        material.scatterParameter = bond.scatter.modulus
    material.scatter = bond.scatter.kind
    if bond.grain_scatter is not None:
        material.grainModulus = bond.grain_scatter.modulus
        material.grainReferenceDiameter = bond.grain_scatter.reference_diameter or 0
    if bond.kind == "parallel":
        material.bondStiffness = bond.stiffness_kind
        material.bondKn = bond.normal_stiffness
        material.bondKs = bond.shear_stiffness
        material.bondRadiusRatio = bond.radius_ratio
        material.momentContribution = bond.moment_contribution
    return material


def _contact_stiffness(card: Card) -> dict[str, float]:
    """Stiffness of one element, total [N/m] or by YADE's rule for a modulus E: kn = 2 E R, ks in proportion."""
    normal, shear = card.contact.normal_stiffness, card.contact.shear_stiffness
    if card.contact.stiffness_kind == "total":
        return {"kn": normal, "ks": shear}
    if card.contact.law == "hertz":  # whose moduli BondMat keeps as young and poisson
        diameter = 2 * card.element.radius
        return {"kn": diameter * normal, "ks": diameter * shear}
    return {"young": normal, "poisson": shear / normal}


def _contact_options(card: Card) -> dict[str, float | str]:
    """What contacts of elements are beyond linear springs with friction."""
    contact = card.contact
    options = {"unloadingRatio": contact.unloading_ratio, **_rolling(card)}
    if contact.law == "hertz":
        solid = {"young": contact.young_modulus, "poisson": contact.poisson_ratio}
        options |= {"contactLaw": "hertz", **solid}
    return options


def _rolling(card: Card) -> dict[str, float]:
    """Rolling resistance of a body; a contact has one only when both bodies have."""
    contact = card.contact
    return {
        "rollingStiffness": contact.rolling_stiffness,
        "rollingFriction": contact.rolling_friction,
    }


def platen_material(card: Card) -> BondMat:
    """Material of the platens: never bonded, ten times as stiff as an element unless the card says otherwise.

    For Hertz elements it is rigid.
    """
    radius = card.element.radius
    own = _contact_stiffness(card)
    normal = own.get("kn", 2 * own.get("young", 0) * radius)
    shear = own.get("ks", own.get("poisson", 0) * normal)
    stiffness = card.crush.platen_stiffness
    friction = card.crush.platen_friction
    return BondMat(
        label="platen",
        kn=10 * normal if stiffness is None else stiffness,
        ks=10 * shear if stiffness is None else stiffness,
        frictionAngle=atan(card.contact.friction_coefficient if friction is None else friction),
        thickness=card.thickness if card.dimension == 2 else 0,
        **_rolling(card),
    )
