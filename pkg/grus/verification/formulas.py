"""The equations of a bonded pair, written down again without any code of the engines.

Potyondy & Cundall (2004), Int. J. Rock Mech. Min. Sci. 41:1329-1364, eqs 11-17, with the moment contribution beta of
Potyondy (2011). Local axes of a pair: n from particle 1 to 2, t and b across it, b = n x t. Loads act on particle 2.
"""

from dataclasses import dataclass
from math import hypot, inf, pi


@dataclass(frozen=True)
class Motion:
    """Relative motion of a pair from the state without force.

    overlap: approach along n [m], negative when pulled apart.
    slip: of particle 2 against 1 along t [m].
    bending: rotation of particle 1 against 2 about `axis` [rad]; axis: (t, b) components, a unit vector.
    twist: rotation of particle 1 against 2 about n [rad].
    """

    overlap: float = 0.0
    slip: float = 0.0
    bending: float = 0.0
    twist: float = 0.0
    axis: tuple[float, float] = (0.0, 1.0)

    def times(self, factor: float) -> "Motion":
        parts = (self.overlap, self.slip, self.bending, self.twist)
        return Motion(*(factor * part for part in parts), self.axis)


@dataclass(frozen=True)
class BondedPair:
    """Two elements and what holds them together.

    kind: 'contact' or 'parallel'; radii of the elements [m]; thickness of discs [m], 0 for spheres.
    kn, ks: stiffness of one element [N/m], two in series in the contact; friction: coefficient of the contact.
    way: 'total' [N/m], 'area' [Pa/m] or 'modulus' [Pa]; bond_kn, bond_ks: in that unit.
    beta: weight of the moments; tensile, shear: strengths ([N] of a contact bond, [Pa] of a parallel bond);
    tan_phi: of the Mohr-Coulomb shear strength of the bond.
    """

    kind: str
    thickness: float = 0.0
    radii: tuple[float, float] = (1.0e-3, 1.4e-3)
    ratio: float = 0.8
    kn: float = 4.0e6
    ks: float = 3.0e6
    friction: float = 0.5
    way: str = "total"
    bond_kn: float = 2.0e6
    bond_ks: float = 1.5e6
    beta: float = 1.0
    tensile: float = inf
    shear: float = inf
    tan_phi: float = 0.0

    @property
    def parallel(self) -> bool:
        return self.kind == "parallel"

    @property
    def bond_radius(self) -> float:
        return self.ratio * min(self.radii)

    @property
    def section(self) -> tuple[float, float, float]:
        """Area [m2], second moment [m4] and polar moment [m4] of the bond (eq. 13, 14; no twist of discs)."""
        r, t = self.bond_radius, self.thickness
        if t > 0:
            return 2 * r * t, 2 / 3 * r**3 * t, 0.0
        return pi * r**2, pi * r**4 / 4, pi * r**4 / 2

    @property
    def per_area(self) -> tuple[float, float]:
        """Normal and shear stiffness of the bond per area [Pa/m]."""
        share = {
            "total": 1 / self.section[0],
            "area": 1.0,
            "modulus": 1 / sum(self.radii),
        }[self.way]
        return share * self.bond_kn, share * self.bond_ks

    def contact_load(self, m: Motion) -> tuple[float, float]:
        """Normal force and shear force along t [N] of the contact, moved from 0 in proportion."""
        kn, ks = self.kn / 2, self.ks / 2
        normal, shear = kn * m.overlap, -ks * m.slip
        if not self.parallel:
            return normal, shear
        normal = max(normal, 0.0)
        limit = self.friction * normal
        return normal, max(-limit, min(limit, shear))

    def bond_load(self, m: Motion) -> tuple[float, float, float, float]:
        """Normal and shear force [N], bending and twisting moment [N m] of a parallel bond (eqs 11-14)."""
        if not self.parallel:
            return 0.0, 0.0, 0.0, 0.0
        (area, inertia, polar), (kn, ks) = self.section, self.per_area
        return (
            kn * area * m.overlap,
            -ks * area * m.slip,
            kn * inertia * m.bending,
            ks * polar * m.twist,
        )

    def energy(self, m: Motion) -> float:
        """Elastic energy of contact and bond [J]."""
        contact = self.contact_load(m)
        stiffness = (self.kn / 2, self.ks / 2)
        stored = sum(f**2 / (2 * k) for f, k in zip(contact, stiffness) if k)
        return stored + self.bond_energy(m)

    def bond_energy(self, m: Motion) -> float:
        """Elastic energy of a parallel bond alone [J]: half of load times motion."""
        normal, shear, bending, twist = self.bond_load(m)
        return (normal * m.overlap - shear * m.slip + bending * m.bending + twist * m.twist) / 2

    def stresses(self, m: Motion) -> tuple[float, float, float]:
        """Largest tension, largest shear and mean normal stress, compression positive (eq. 15): [Pa], or [N] of a
        contact bond."""
        if not self.parallel:
            normal, shear = self.contact_load(m)
            return -normal, abs(shear), normal
        (area, inertia, polar), r = self.section, self.bond_radius
        normal, shear, bending, twist = self.bond_load(m)
        torsion = self.beta * abs(twist) * r / polar if polar else 0.0
        return (
            -normal / area + self.beta * abs(bending) * r / inertia,
            abs(shear) / area + torsion,
            normal / area,
        )

    def load_to_break(self, m: Motion) -> tuple[float, int]:
        """Factor on the motion at which the bond breaks, and the mode (1 tension, 2 shear).

        Stresses grow in proportion, so tension meets sigma_c at sigma_c / tension and shear meets
        c + normal tan(phi) at c / (shear - normal tan(phi)).
        """
        tension, shear, normal = self.stresses(m)
        excess = shear - normal * self.tan_phi
        in_tension = self.tensile / tension if tension > 0 else inf
        in_shear = self.shear / excess if excess > 0 else inf
        return min((in_tension, 1), (in_shear, 2))

    def released(self, m: Motion) -> float:
        """Energy that a break at motion `m` releases [J]: that of a parallel bond; of a contact bond all that the
        remaining frictional contact does not keep."""
        if self.parallel:
            return self.bond_energy(m)
        normal, shear = max(0.0, self.contact_load(m)[0]), abs(self.contact_load(m)[1])
        kept = min(shear, self.friction * normal)
        return self.energy(m) - normal**2 / self.kn - kept**2 / self.ks

    def left_after_break(self, m: Motion) -> float:
        """Force that a broken bond leaves [N]: contact and friction."""
        normal = max(0.0, self.kn / 2 * m.overlap)
        shear = min(self.ks / 2 * abs(m.slip), self.friction * normal)
        return hypot(normal, shear)
