"""A block of bonded spheres between two rigid layers."""

from dataclasses import dataclass

import numpy as np
from yade import O
from yade.wrapper import NewtonIntegrator

from grus.verification.law import Law

COUNTS = (4, 5, 5)  # spheres along x and y, layers along z
SCATTER = 0.05  # half range of the factors on the strengths
SEED = 1
SAMPLES = 40


@dataclass(frozen=True)
class BlockCurve:
    """What a block of so many spheres did: displacement (n,) of the upper layer [m], force (n,) that moves it [N],
    number (n,) of bonds that still hold."""

    spheres: int
    displacement: np.ndarray
    force: np.ndarray
    bonds: np.ndarray

    @property
    def peak(self) -> float:
        """Largest force of the run [N]."""
        return float(self.force.max())

    @property
    def broken_at_peak(self) -> int:
        return int(self.bonds[0] - self.bonds[self.force.argmax()])

    @property
    def broken(self) -> int:
        return int(self.bonds[0] - self.bonds[-1])


def hexagonal_block(radius: float) -> np.ndarray:
    """Centres (n, 3) [m] of a hexagonal close packing with layers ABAB normal to z."""
    rows = np.array(
        [(i, j, k) for k in range(COUNTS[2]) for j in range(COUNTS[1]) for i in range(COUNTS[0])]
    )
    i, j, k = rows.T
    x = 2 * i + (j + k) % 2
    y = np.sqrt(3) * (j + (k % 2) / 3)
    z = 2 * np.sqrt(2 / 3) * k
    return radius * np.stack([x, y, z], axis=1)


def load_block(law: Law, radius: float, velocity: np.ndarray, dt: float, steps: int) -> BlockCurve:
    """Moves the upper layer at `velocity` (3,) [m/s] against the fixed lower one, from the state without force.

    The strengths of the bonds are multiplied by factors that depend on nothing but the pair, the same for every law:
    in a regular packing of equal bonds rounding would decide which of them break first.
    """
    O.reset()
    O.materials.append(law.material)
    centres = hexagonal_block(radius)
    for centre in centres:
        O.bodies.append(law.sphere(centre, radius))
    layer = np.rint(centres[:, 2] / (2 * np.sqrt(2 / 3) * radius)).astype(int)
    top = [i for i, k in enumerate(layer) if k == COUNTS[2] - 1]
    for body in O.bodies:
        if layer[body.id] in (0, COUNTS[2] - 1):
            body.state.blockedDOFs = "xyzXYZ"
    O.engines = [*law.interaction_engines(), NewtonIntegrator(damping=0)]
    O.dt = 0
    O.step()
    law.born()
    _scatter(law)
    for i in top:
        O.bodies[i].state.vel = velocity
    O.dt = dt
    direction = velocity / np.linalg.norm(velocity)
    samples = [_sample(law, top, direction, centres)]
    for step in range(1, steps + 1):
        O.step()
        if step % (steps // SAMPLES) == 0:
            samples.append(_sample(law, top, direction, centres))
    return BlockCurve(len(centres), *np.array(samples).T)


def _scatter(law: Law) -> None:
    generator = np.random.Generator(np.random.PCG64(np.random.SeedSequence(SEED)))
    pairs = sorted((min(i.id1, i.id2), max(i.id1, i.id2)) for i in O.interactions if i.isReal)
    for pair, u in zip(pairs, generator.random(len(pairs))):
        law.weaken(O.interactions[pair], 1 + SCATTER * (2 * u - 1))


def _sample(law: Law, top: list[int], direction: np.ndarray, centres: np.ndarray) -> tuple:
    moved = np.array(O.bodies[top[0]].state.pos) - centres[top[0]]
    force = -np.sum([O.forces.f(i) for i in top], axis=0)
    return moved @ direction, force @ direction, sum(law.holds(i) for i in O.interactions)
