"""Free elastic assemblies and their exact critical step."""

from dataclasses import dataclass

import numpy as np
from scipy.linalg import eigh

from grus.verification.formulas import BondedPair
from grus.verification.law import DENSITY, REACH

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

    def highest_mode(self) -> tuple[float, np.ndarray]:
        """Critical step of central differences 2 / omega_max [s], from the eigenvalues of the whole assembly, and
        the shape (n, 6) of that mode, 1 at most."""
        masses = np.tile([self.mass] * 3 + [self.inertia] * 3, len(self.centres))
        free = np.tile(self.free, len(self.centres))
        stiffness = self.stiffness()[np.ix_(free, free)]
        last = [free.sum() - 1] * 2
        squares, shapes = eigh(stiffness, np.diag(masses[free]), subset_by_index=last)
        shape = np.zeros(len(free))
        shape[free] = shapes[:, 0] / np.abs(shapes).max()
        return 2 / np.sqrt(squares[0]), shape.reshape(-1, 6)

    def random_motion(self, speed: float) -> np.ndarray:
        """Velocities (n, 6) [m/s], [rad/s] of the elements, of this size at their rims; seeded."""
        generator = np.random.Generator(np.random.PCG64(np.random.SeedSequence(SEED)))
        size = speed / np.array([1, 1, 1, *[self.radius] * 3])
        return self.free * size * (2 * generator.random((len(self.centres), 6)) - 1)

    @property
    def free(self) -> np.ndarray:
        """Mask (6,) of the degrees of freedom of an element: ux uy uz rx ry rz."""
        return np.array([not self.plane or axis in (0, 1, 5) for axis in range(6)])


def _cross(a: np.ndarray) -> np.ndarray:
    """Matrix of b -> a x b."""
    x, y, z = a
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
