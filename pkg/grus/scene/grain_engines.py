"""All engines of a test on grains."""

from yade import O
from yade.wrapper import BondTimeStepper, Engine, GrainLoop, NewtonIntegrator

from grus.host.differences import leapfrog
from grus.scene.bonding import bond
from grus.scene.loop import InteractionEngines
from grus.specimen import Specimen

LOOPS = ("GrainLoop", "InteractionLoop")
SUBSTEPS = 1000
"""Time steps that GrainLoop does before it hands back to YADE, which costs as much as 10 to 20 of them; also those between
two updates of the time step."""

CALMING = 0.8
"""Damping of grains that are to come to rest without being in a test."""
QUENCHES, QUENCH = 20, 500
"""How often grains are stopped, and time steps before each time."""


class GrainEngines:
    """All engines of a test on grains, with GrainLoop or with YADE's own engines in its place.

    loop: 'GrainLoop' or 'InteractionLoop' (which takes NewtonIntegrator along). loading: engines that measure the forces
    on walls and set the walls' velocities. safety: time step over the critical one. skin: of GrainLoop. `start()` puts
    them into `O.engines`.
    """

    def __init__(self, loop: str, damping: float, safety: float, skin: float = 0) -> None:
        self.loop, self.damping, self.skin = loop, damping, skin
        self.interactions = InteractionEngines()
        # One for all: the collider stays with the first that it meets.
        self.newton = leapfrog(damping=damping, gravity=(0, 0, 0))
        self.ledger = self.interactions.ledger
        self.stepper = BondTimeStepper(safety=safety, timeStepUpdateInterval=SUBSTEPS)

    def bond(self, specimen: Specimen) -> int:
        """Bonds the elements of each grain, as `grus.scene.bond`; returns the number of bonds."""
        O.engines = [*self.interactions.list, self.newton]
        return bond(specimen, self.interactions)

    def start(self, loading: list[Engine]) -> None:
        """Sets `O.engines`, with the `loading` engines at their place, and the time step."""
        if self.loop == "GrainLoop":
            grains = GrainLoop(
                substeps=SUBSTEPS,
                skin=self.skin,
                damping=self.damping,
                ledger=self.ledger,
                loading=loading,
            )
            O.engines = [self.stepper, grains]
        else:
            O.engines = [*self.interactions.list, self.stepper, *loading, self.newton]
        # The stepper acts at round numbers of steps only, and bonding has taken the first.
        O.dt = min(self.stepper.maxDt, self.stepper.safety * self.stepper.critical())

    def run(self, count: int) -> None:
        """Runs a few time steps, for which `O.run` would take longer to start and stop than to run.

        Ends earlier when an engine ends the run, as a servo does at the end of its stage.
        """
        end = O.iter + count
        self._hand_back_after(count)
        O.stopAtIter = end
        while O.iter < end and O.stopAtIter == end:
            O.step()
        self._hand_back_after(SUBSTEPS)

    def _hand_back_after(self, substeps: int) -> None:
        for one in O.engines:
            if isinstance(one, GrainLoop):
                one.substeps = substeps

    def quench(self) -> None:
        """Takes all motion from the grains again and again: without gravity, loose ones would fly on for ever."""
        for _ in range(QUENCHES):
            self.run(QUENCH)
            stop_grains()


def set_damping(damping: float) -> None:
    """Changes YADE's local damping [-] of the engines that move the grains of the current scene."""
    for one in O.engines:
        if isinstance(one, (GrainLoop, NewtonIntegrator)):
            one.damping = damping


def stop_grains() -> None:
    """Sets the velocities of all grains of the current scene to zero."""
    for body in O.bodies:
        if body.state.blockedDOFs != "xyzXYZ":
            body.state.vel = body.state.angVel = (0, 0, 0)
