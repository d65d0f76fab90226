"""The oedometer test of a prepared specimen in YADE."""

from math import atan

import numpy as np
from yade import O, utils
from yade.wrapper import BondLedger, BondMat, GrainLoop, OedometerServo

from grus.card import Card
from grus.errors import GrusError
from grus.oedometer.clock import add_ageing, ageing, rests
from grus.preparation import PreparedSpecimen
from grus.record import Record
from grus.scene import GrainEngines, grain_material, insert

UNITS = {
    "iter": "1",
    "time": "s",
    "stage": "1",
    "height": "m",
    "top_stress": "Pa",
    "bottom_stress": "Pa",
    "side_stress": "Pa",
    "tension_breaks": "1",
    "shear_breaks": "1",
    "unbalanced": "1",
    "inertial_number": "1",
    "speed_limit": "m/s",
    "work": "J",
    "elastic_energy": "J",
    "kinetic_energy": "J",
    "released_energy": "J",
    "sliding_work": "J",
    "damped_energy": "J",
}


class OedometerTest:
    """A prepared specimen between platens in a box with fixed sides, in the current YADE scene, which is emptied first.

    After construction the grains are bonded and the platens stand where the preparation left them. All state is in the
    scene, so that one that was saved and loaded goes on without this object.
    """

    def __init__(self, card: Card, prepared: PreparedSpecimen) -> None:
        if card.oedometer is None:
            raise GrusError(
                f"{card.source}: oedometer is missing; allowed: a table [oedometer] with stages"
            )
        self.card, self.prepared = card, prepared
        O.reset()
        O.trackEnergy = True
        axis = card.dimension - 1
        walls = self._walls(axis)
        insert(prepared.specimen, grain_material(card))
        test = card.oedometer
        engines = GrainEngines(test.loop, test.damping, test.time_step_safety)
        servo = OedometerServo(
            bottom=walls[axis][0],
            top=walls[axis][1],
            sides=[wall for other in range(axis) for wall in walls[other]],
            axis=axis,
            moving=test.platens or "both",
            solidVolume=prepared.outline_volume,
            ledger=engines.ledger,
            maxSpeed=test.speed,
            fastSpeed=test.fast_speed or 0,
            tolerance=test.tolerance,
            unbalancedLimit=test.unbalanced_limit,
            quietSteps=test.quiet_steps,
            inertialLimit=test.inertial_limit,
            recordStrain=test.record_strain,
            recordStress=test.record_stress,
            grainDiameter=float(prepared.specimen.grain_diameter.mean()),
            grainDensity=card.element.density,
            **self._areas(axis),
        )
        self.bonds = engines.bond(prepared.specimen)
        engines.start([servo])
        # Shear forces of contacts are not kept with a specimen: they build up here, between resting platens.
        engines.quench()
        add_ageing(card, servo)

    @property
    def record(self) -> Record:
        """What the servo has recorded so far."""
        return record()

    @property
    def rests(self) -> Record:
        """What the laboratory clock has recorded so far."""
        return rests()

    def _walls(self, axis: int) -> list[tuple[int, int]]:
        """Ids of the two walls across each axis."""
        test, element = self.card.oedometer, grain_material(self.card)
        own = element.kn if element.kn >= 0 else 2 * element.young * self.card.element.radius
        stiffness = own if test.wall_stiffness is None else test.wall_stiffness
        O.materials.append(
            BondMat(
                label="wall",
                kn=stiffness,
                ks=stiffness,
                frictionAngle=atan(test.wall_friction),
                thickness=self.card.thickness or 0,
            )
        )
        ids = []
        for across in range(axis + 1):
            ends = (self.prepared.lower[across], self.prepared.upper[across])
            walls = [utils.wall(float(end), axis=across, material="wall") for end in ends]
            for wall in walls:
                # Otherwise NewtonIntegrator books damping of their prescribed motion as lost energy.
                wall.state.isDamped = False
            ids.append(tuple(O.bodies.append(walls)))
        return ids

    def _areas(self, axis: int) -> dict[str, float]:
        size = np.subtract(self.prepared.upper, self.prepared.lower)
        if axis == 1:
            return {"area": size[0] * self.card.thickness, "sideBreadth": self.card.thickness}
        return {"area": size[0] * size[1], "sideBreadth": (size[0] + size[1]) / 2}


def servo() -> OedometerServo:
    """The servo of the current scene, also of one that was loaded."""
    loops = [one for one in O.engines if isinstance(one, GrainLoop)]
    among = loops[0].loading if loops else O.engines
    return next(one for one in among if isinstance(one, OedometerServo))


def ledger() -> BondLedger:
    """The ledger of the current scene."""
    return servo().ledger


def at_end() -> bool:
    """Whether the stage of the current scene has ended: at rest, and not in a hold whose time goes on."""
    clock = ageing()
    return servo().done and not (clock is not None and clock.holding)


def record() -> Record:
    """What the servo of the current scene has recorded so far."""
    s = servo()
    columns = (
        s.recordIter,
        s.recordTime,
        s.recordStage,
        s.recordHeight,
        s.recordTop,
        s.recordBottom,
        s.recordSide,
        s.recordTension,
        s.recordShear,
        s.recordUnbalanced,
        s.recordInertial,
        s.recordSpeed,
        s.recordWork,
        s.recordElastic,
        s.recordKinetic,
        s.recordReleased,
        s.recordSliding,
        s.recordDamped,
    )
    return Record(dict(zip(UNITS, map(np.array, columns))), UNITS)


def element_ids() -> list[int]:
    """Ids of the elements of the current scene, in the order of the specimen."""
    return [body.id for body in O.bodies if getattr(body.state, "grain", -1) >= 0]
