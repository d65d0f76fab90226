"""The top platen under a servo, in Python: it closes at a capped speed and keeps a stress."""

import builtins

from dem.scene import O, Specimen, wrapper

PERIOD = 20  # steps between two looks
TIME = 6e-4  # in which the servo aims to remove what is missing [s]
# Modulus of a specimen, rather too large: LOOSE + STIFFENING x stress [Pa], [1].
LOOSE, STIFFENING = 1.4e8, 500.0
PACE_TIME = 3e-3  # in which the platen finds its pace [s]
NEAR = 0.03  # share of the target within which it does
QUIET = 600  # steps of a stretch in which nothing breaks
STRETCHES = 3
MOST = 200  # stretches to wait for
CLOSING = 0.4  # speed of packing [m/s]
BEARING = 10  # looks in a row at which both platens bear
TOLERANCE = 0.005
CREEPING = 1e-6  # change of strain in a quiet stretch that is none [1]


class Servo:
    """Moves the top platen of a specimen. Stresses [Pa], speeds [m/s]."""

    def __init__(self, specimen: Specimen, stiffness: float, speed: float):
        self.specimen, self.speed = specimen, speed
        self.stiffness = stiffness
        self.target = self.pace = 0.0
        builtins.concealed_servo = self.look  # PyRunner knows text, no functions
        O.engines = O.engines[:4] + [
            wrapper.PyRunner(iterPeriod=PERIOD, command="__import__('builtins').concealed_servo()")
        ]

    def look(self) -> None:
        stress = self.specimen.stresses()[0]
        modulus = self.stiffness * (LOOSE + STIFFENING * stress)
        speed = self.specimen.height / (TIME * modulus) * (self.target - stress)
        # What a specimen that gives way needs: without it the platen would crawl after the stress.
        if abs(self.target - stress) < NEAR * self.target:
            self.pace = self._capped(self.pace + speed * PERIOD * O.dt / PACE_TIME)
        O.bodies[3].state.vel = (0, -self._capped(speed + self.pace), 0)

    def _capped(self, speed: float) -> float:
        return min(max(speed, -self.speed), self.speed)

    def aim(self, stress: float) -> None:
        """A new target [Pa]."""
        self.target, self.pace = stress, 0.0

    def reached(self) -> bool:
        stress = self.specimen.stresses()[0]
        return abs(stress - self.target) < TOLERANCE * max(self.target, 2e4)

    def pack(self, void_ratio: float, stress: float) -> None:
        """Closes the platen until the specimen is that dense, or bears `stress` at both ends for long."""
        self.speed, bears = CLOSING, 0
        self.aim(1e9)  # as fast as it may
        while self.specimen.void_ratio > void_ratio and bears < BEARING:
            O.run(100, True)
            bears = bears + 1 if min(self.specimen.stresses()[:2]) > stress else 0

    def rest(
        self, row=None, stretches: int = STRETCHES, length: int = QUIET, most: int = MOST
    ) -> None:
        """Runs until nothing breaks in some stretches and the specimen stands; `row` is called after each."""
        quiet, steps, broken, height = 0, 0, self.specimen.breaks(), self.specimen.height
        while quiet < stretches and steps < most * QUIET:
            O.run(length, True)
            steps += length
            now, reached = self.specimen.breaks(), self.reached()
            still = abs(self.specimen.height - height) / height < CREEPING * length / QUIET
            quiet = quiet + 1 if now == broken and reached and still else 0
            broken, height = now, self.specimen.height
            if row:
                row()
