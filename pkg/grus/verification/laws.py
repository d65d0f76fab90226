"""Three laws of bonded contacts in YADE, made equal as far as they can be.

Of a pair without moments the three coincide: springs kn and ks, a limit of tension, a limit of shear that grows with
the normal force by tan(phi), and the same friction afterwards. Their parameters do not:

| | contact bond of Grus | CohFrict | JCFpm |
|---|---|---|---|
| kn of the contact | two elements in series | h(E r), harmonic mean | h(E r) |
| ks | two elements in series | h(nu E r) | h(nu E r) |
| tension limit [N] | tensileStrength | normalCohesion Rmin^2 | tensileStrength pi Rmin^2 |
| shear limit [N] | shearStrength | shearCohesion Rmin^2 | cohesion pi Rmin^2 |
| friction | of bond and contact apart | one angle | one angle |

For equal radii h(E r) = E r, so E = kn / r and nu = ks / kn, with kn and ks of the whole contact.
"""

from math import atan, pi

from yade.wrapper import (
    BondLedger,
    BondMat,
    CohFrictMat,
    Ig2_Sphere_Sphere_ScGeom,
    Ig2_Sphere_Sphere_ScGeom6D,
    Ip2_BondMat_BondMat_BondPhys,
    Ip2_CohFrictMat_CohFrictMat_CohFrictPhys,
    Ip2_JCFpmMat_JCFpmMat_JCFpmPhys,
    JCFpmMat,
    Law2_ScGeom6D_CohFrictPhys_CohesionMoment,
    Law2_ScGeom_BondPhys_Bonded,
    Law2_ScGeom_JCFpmPhys_JointedCohesiveFrictionalPM,
)

from grus.host.differences import set_moment_bounds
from grus.verification.formulas import BondedPair
from grus.verification.law import DENSITY, Law

NEVER = 1e200  # stands for a strength that is never reached: archives and parsers know no inf


def grus_law(pair: BondedPair) -> Law:
    """Contact bond or parallel bond of Grus; `law.engines` holds its ledger."""
    material = BondMat(
        density=DENSITY,
        frictionAngle=atan(pair.friction),
        kn=pair.kn,
        ks=pair.ks,
        bond=pair.kind,
        bondStiffness=pair.way,
        bondKn=pair.bond_kn,
        bondKs=pair.bond_ks,
        bondRadiusRatio=pair.ratio,
        momentContribution=pair.beta,
        tensileStrength=min(pair.tensile, NEVER),
        shearStrength=min(pair.shear, NEVER),
        bondFrictionAngle=atan(pair.tan_phi),
        thickness=pair.thickness,
    )
    ledger = BondLedger()
    return Law(
        material,
        Ig2_Sphere_Sphere_ScGeom(),
        Ip2_BondMat_BondMat_BondPhys(bonding=True),
        Law2_ScGeom_BondPhys_Bonded(ledger=ledger),
        ("tensileStrength", "shearStrength"),
        [ledger],
    )


def cohfrict_law(
    pair: BondedPair, alpha_kr: float = 0.0, alpha_ktw: float = 0.0, moment_bounds: bool = False
) -> Law:
    """YADE's CohFrict; with moments when `alpha_kr` or `alpha_ktw` is not 0, which break bonds if `moment_bounds`."""
    radius = min(pair.radii)
    moments = alpha_kr != 0 or alpha_ktw != 0
    material = CohFrictMat(
        density=DENSITY,
        **_elastic(pair),
        isCohesive=True,
        fragile=True,
        normalCohesion=min(pair.tensile, NEVER) / radius**2,
        shearCohesion=min(pair.shear, NEVER) / radius**2,
        momentRotationLaw=moments,
        alphaKr=alpha_kr,
        alphaKtw=alpha_ktw,
    )
    physics = Ip2_CohFrictMat_CohFrictMat_CohFrictPhys(setCohesionNow=True)
    set_moment_bounds(material, physics, moment_bounds)
    return Law(
        material,
        Ig2_Sphere_Sphere_ScGeom6D(),
        physics,
        Law2_ScGeom6D_CohFrictPhys_CohesionMoment(),
        ("normalAdhesion", "shearAdhesion"),
    )


def jcfpm_law(pair: BondedPair) -> Law:
    """YADE's JCFpm, without joints and without its own scatter; contacts of the first step are bonded."""
    area = pi * min(pair.radii) ** 2
    material = JCFpmMat(
        density=DENSITY,
        **_elastic(pair),
        type=1,
        tensileStrength=min(pair.tensile, NEVER) / area,
        cohesion=min(pair.shear, NEVER) / area,
    )
    return Law(
        material,
        Ig2_Sphere_Sphere_ScGeom(),
        Ip2_JCFpmMat_JCFpmMat_JCFpmPhys(),
        Law2_ScGeom_JCFpmPhys_JointedCohesiveFrictionalPM(),
        ("FnMax", "FsMax"),
    )


def _elastic(pair: BondedPair) -> dict[str, float]:
    """Parameters of YADE's frictional materials for the contact of a pair of equal radii."""
    return {
        "young": pair.kn / 2 / pair.radii[0],
        "poisson": pair.ks / pair.kn,
        "frictionAngle": atan(pair.friction),
    }
