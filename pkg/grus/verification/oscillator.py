"""Free elastic assemblies: their exact critical step, and what YADE does with a given step."""

from dataclasses import dataclass

import numpy as np
from scipy.linalg import eigh
from yade import O, utils
from yade.wrapper import (
    Bo1_Sphere_Aabb,
    ForceResetter,
    InsertionSortCollider,
    InteractionLoop,
    NewtonIntegrator,
)

from grus.verification.formulas import BondedPair
from grus.verification.laws import DENSITY, grus_law

REACH = 1.0001  # of the sum of the radii
SEED = 1


@dataclass(frozen=True)
class Assembly:
    """Equal elements that touch, free in space or (discs) in the plane, bonded as `pair` says.

    centres: (n, 3) [m].
    """

    name: str
    centres: np.ndarray
    pair: BondedPair

    @property
    def plane(self) -> bool:
        return self.pair.thickness > 0

    @property
    def radius(self) -> float:
        return self.pair.radii[0]

    @property
    def mass(self) -> float:
        """Of a sphere or disc [kg]."""
        r, t = self.radius, self.pair.thickness
        return DENSITY * np.pi * (r**2 * t if self.plane else 4 / 3 * r**3)

    @property
    def inertia(self) -> float:
        """Of a sphere or disc about its axis [kg m2]."""
        return (0.5 if self.plane else 0.4) * self.mass * self.radius**2

    @property
    def contacts(self) -> list[tuple[int, int]]:
        return [
            (i, j)
            for j in range(len(self.centres))
            for i in range(j)
            if np.linalg.norm(self.centres[i] - self.centres[j]) < 2 * self.radius * REACH
        ]

    def stiffness(self) -> np.ndarray:
        """Stiffness matrix (6 n, 6 n) of all bonds in the state without force."""
        kn, ks, kb, kt = self._springs()
        total = np.zeros((6 * len(self.centres),) * 2)
        for i, j in self.contacts:
            n = (self.centres[j] - self.centres[i]) / (2 * self.radius)
            along, lever = np.outer(n, n), _cross(self.radius * n)
            # Relative motion (12): displacement of j against i at the contact, rotation of j against i.
            motion = np.zeros((6, 12))
            motion[:3, :3], motion[:3, 3:6] = -np.eye(3), lever
            motion[:3, 6:9], motion[:3, 9:] = np.eye(3), lever
            motion[3:, 3:6], motion[3:, 9:] = -np.eye(3), np.eye(3)
            springs = np.zeros((6, 6))
            springs[:3, :3] = kn * along + ks * (np.eye(3) - along)
            springs[3:, 3:] = kt * along + kb * (np.eye(3) - along)
            both = np.r_[6 * i : 6 * i + 6, 6 * j : 6 * j + 6]
            total[np.ix_(both, both)] += motion.T @ springs @ motion
        return total

    def _springs(self) -> tuple[float, float, float, float]:
        """Normal, shear, bending and twist stiffness of a contact with its bond."""
        pair = self.pair
        if not pair.parallel:
            return pair.kn / 2, pair.ks / 2, 0.0, 0.0
        (area, inertia, polar), (kn, ks) = pair.section, pair.per_area
        return pair.kn / 2 + kn * area, pair.ks / 2 + ks * area, kn * inertia, ks * polar

    def exact_step(self) -> float:
        """Critical step of central differences 2 / omega_max [s], from the eigenvalues of the whole assembly."""
        masses = np.tile([self.mass] * 3 + [self.inertia] * 3, len(self.centres))
        free = np.tile(
            [not self.plane or axis in (0, 1, 5) for axis in range(6)], len(self.centres)
        )
        stiffness = self.stiffness()[np.ix_(free, free)]
        highest = eigh(stiffness, np.diag(masses[free]), eigvals_only=True)[-1]
        return 2 / np.sqrt(highest)


def _cross(a: np.ndarray) -> np.ndarray:
    """Matrix of b -> a x b."""
    x, y, z = a
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


class FreeScene:
    """An assembly in the current YADE scene, which is emptied first, bonded, at random velocities.

    speed: their size [m/s]; so small that geometry stays that of the first step.
    """

    def __init__(self, assembly: Assembly, speed: float) -> None:
        O.reset()
        law = grus_law(assembly.pair)
        O.materials.append(law.material)
        for centre in assembly.centres:
            body = utils.sphere(centre, assembly.radius, color=(1, 1, 1))
            state = body.state
            state.grain = 0
            state.mass, state.inertia = assembly.mass, (assembly.inertia,) * 3
            if assembly.plane:
                state.blockedDOFs = "zXY"
            O.bodies.append(body)
        law.geometry.interactionDetectionFactor = REACH
        O.engines = [
            ForceResetter(),
            InsertionSortCollider([Bo1_Sphere_Aabb(aabbEnlargeFactor=REACH)]),
            InteractionLoop([law.geometry], [law.physics], [law.law]),
            NewtonIntegrator(damping=0),
        ]
        O.dt = 0
        O.step()
        law.born()
        law.geometry.interactionDetectionFactor = 1
        generator = np.random.Generator(np.random.PCG64(np.random.SeedSequence(SEED)))
        shape = (len(assembly.centres), 3)
        velocity = speed * (2 * generator.random(shape) - 1)
        spin = speed / assembly.radius * (2 * generator.random(shape) - 1)
        if assembly.plane:
            velocity[:, 2] = spin[:, :2] = 0
        for body, v, w in zip(O.bodies, velocity, spin):
            body.state.vel, body.state.angVel = v, w
        self.assembly = assembly

    def kept_energy(self, dt: float, steps: int) -> np.ndarray:
        """Energy (steps,) [J] that leapfrog keeps in a linear system: the elastic one, and the kinetic one with the
        product of the velocities half a step before and after."""
        O.dt = dt
        energy = np.empty(steps)
        before = self._velocities()
        for step in range(steps):
            O.step()
            after = self._velocities()
            elastic = sum(i.phys.elasticEnergy() for i in O.interactions if i.isReal)
            energy[step] = elastic + 0.5 * float((self._masses() * before * after).sum())
            before = after
        return energy

    def growth(self, dt: float, steps: int) -> float:
        """Mean logarithmic growth of kinetic energy in a step over the last half of so many steps."""
        O.dt = dt
        kinetic = []
        for half in (steps - steps // 2, steps // 2):
            for _ in range(half):
                O.step()
            kinetic.append(float((self._masses() * self._velocities() ** 2).sum()))
        return float(np.log(kinetic[1] / kinetic[0])) / (steps // 2)

    def _velocities(self) -> np.ndarray:
        return np.array([[*b.state.vel, *b.state.angVel] for b in O.bodies])

    def _masses(self) -> np.ndarray:
        return np.array([self.assembly.mass] * 3 + [self.assembly.inertia] * 3)
