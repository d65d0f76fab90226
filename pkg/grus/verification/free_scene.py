"""What YADE does with a free elastic assembly at a given time step."""

import numpy as np
from yade import O
from yade.wrapper import NewtonIntegrator, TimeStepper

from grus.verification.assembly import Assembly
from grus.verification.laws import grus_law


class FreeScene:
    """An assembly in the current YADE scene, which is emptied first, bonded and without force.

    velocity: (n, 6) of the elements [m/s] and [rad/s], small enough to leave the geometry as it is.
    """

    def __init__(self, assembly: Assembly, velocity: np.ndarray) -> None:
        O.reset()
        law = grus_law(assembly.pair)
        O.materials.append(law.material)
        for centre in assembly.centres:
            body = law.sphere(centre, assembly.radius)
            state = body.state
            state.mass, state.inertia = assembly.mass, (assembly.inertia,) * 3
            if assembly.plane:
                state.blockedDOFs = "zXY"
            O.bodies.append(body)
        O.engines = [*law.interaction_engines(), NewtonIntegrator(damping=0)]
        O.dt = 0
        O.step()
        law.born()
        for body, row in zip(O.bodies, velocity):
            body.state.vel, body.state.angVel = row[:3], row[3:]
        self.assembly = assembly

    def set_step(self, stepper: TimeStepper) -> float:
        """Puts `stepper` to work before each motion; returns the step that it sets now [s]."""
        stepper.timeStepUpdateInterval = 1
        O.engines = O.engines[:-1] + [stepper, O.engines[-1]]
        O.step()
        return O.dt

    def kept_energy(self, steps: int) -> np.ndarray:
        """Energy (steps,) [J] that leapfrog keeps in a linear system: the elastic one, and the kinetic one with the
        product of the velocities half a step before and after."""
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
