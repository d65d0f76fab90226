"""Two elements in YADE whose motion is prescribed."""

import numpy as np
from scipy.spatial.transform import Rotation
from yade import O
from yade.wrapper import Interaction, NewtonIntegrator

from grus.verification.formulas import Motion
from grus.verification.law import Law

AXES = {  # n, t and b of a pair; in the plane b is the axis of the plane
    False: np.array([[1, 2, 2], [2, 1, -2], [-2, 2, -1]]) / 3,
    True: np.array([[0.6, 0.8, 0.0], [-0.8, 0.6, 0.0], [0.0, 0.0, 1.0]]),
}
STEP = 1e-6  # [s]


class PairScene:
    """A bonded pair in the current YADE scene, which is emptied first.

    All motion is prescribed as velocities, so a step is exact: first the bodies move, then the law sees positions and
    the velocities that led to them. Slip and rotations are made by spins alone, which leave the normal where it is.
    law: what holds the pair; radii of the two elements [m]; plane: discs in the plane.
    swapped: whether the second element is put into YADE before the first.
    """

    def __init__(
        self,
        law: Law,
        radii: tuple[float, float],
        plane: bool = False,
        swapped: bool = False,
    ) -> None:
        O.reset()
        self.law, self.radii = law, np.array(radii)
        self.normal, self.across, self.binormal = AXES[plane]
        O.materials.append(law.material)
        centres = [np.zeros(3), sum(radii) * self.normal]
        order = (1, 0) if swapped else (0, 1)
        bodies = {i: law.sphere(centres[i], radii[i]) for i in order}
        self.ids = [0, 0]
        for i in order:
            bodies[i].state.blockedDOFs = "xyzXYZ"
            self.ids[i] = O.bodies.append(bodies[i])
        # What Newton makes of the forces of the last step does not matter: all motion is prescribed.
        O.engines = [NewtonIntegrator(warnNoForceReset=False), *law.interaction_engines()]
        O.dt = STEP
        O.step()
        law.born()

    @property
    def interaction(self) -> Interaction:
        return O.interactions[tuple(self.ids)]

    @property
    def holds(self) -> bool:
        return O.interactions.has(*self.ids) and self.law.holds(self.interaction)

    def drive(self, motion: Motion, steps: int) -> None:
        """Goes through `motion` in so many equal steps."""
        r1, r2 = self.radii
        span = r1 + r2
        duration = steps * STEP
        bend = motion.axis[0] * self.across + motion.axis[1] * self.binormal
        spin = -motion.slip / span * self.binormal
        turn = motion.bending / span * bend
        twist = motion.twist / 2 * self.normal
        approach = motion.overlap / 2 * self.normal
        self._set(0, approach / duration, (spin + r2 * turn + twist) / duration)
        self._set(1, -approach / duration, (spin - r1 * turn - twist) / duration)
        O.dt = STEP
        for _ in range(steps):
            O.step()

    def translate(self, step: np.ndarray) -> None:
        """Moves the second element by `step` (3,) [m] in one step, without spin."""
        self._set(0, np.zeros(3), np.zeros(3))
        self._set(1, step / STEP, np.zeros(3))
        O.dt = STEP
        O.step()

    def turn(self, rotation: np.ndarray, steps: int) -> None:
        """Turns the pair as one rigid body about its middle by the rotation vector (3,) [rad]."""
        step = Rotation.from_rotvec(rotation / steps)
        places = [np.array(O.bodies[i].state.pos) for i in self.ids]
        centre = (places[0] + places[1]) / 2
        arms = [place - centre for place in places]
        O.dt = STEP
        for _ in range(steps):
            after = [step.apply(arm) for arm in arms]
            for i in (0, 1):
                self._set(i, (after[i] - arms[i]) / STEP, rotation / steps / STEP)
            arms = after
            O.step()

    def _set(self, which: int, velocity: np.ndarray, spin: np.ndarray) -> None:
        state = O.bodies[self.ids[which]].state
        state.vel, state.angVel = velocity, spin

    def forces(self) -> np.ndarray:
        """Forces (2, 3) on the two elements [N]."""
        return np.array([O.forces.f(i) for i in self.ids])

    def torques(self) -> np.ndarray:
        """Torques (2, 3) on the two elements about their centres [N m]."""
        return np.array([O.forces.t(i) for i in self.ids])
