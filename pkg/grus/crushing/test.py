"""The crushing test of one grain in YADE."""

import numpy as np
from yade import O, utils
from yade.wrapper import CrushingPlatens

from grus.card import Card
from grus.crushing.result import CrushingResult
from grus.record import Record
from grus.scene import GrainEngines, grain_material, insert, platen_material, snapshot
from grus.specimen import Specimen
from grus.specimen.from_card import grain_from_card

UNITS = {
    "time": "s",
    "closing": "m",
    "force": "N",
    "tension_breaks": "1",
    "shear_breaks": "1",
    "work": "J",
    "elastic_energy": "J",
    "kinetic_energy": "J",
    "released_energy": "J",
    "sliding_work": "J",
    "damped_energy": "J",
}


class CrushingTest:
    """One grain between two platens, in the current YADE scene, which is emptied first.

    After construction the grain is bonded and free of force, the platens touch it, and `O.run()` would start the test.
    `run()` runs it to its end; `result()` takes the outcome.

    card: the model.
    grain: number of the grain, which with the card's seed fixes everything about it.
    specimen: another grain to crush instead of the card's own.
    """

    def __init__(self, card: Card, grain: int = 0, specimen: Specimen | None = None) -> None:
        self.card, self.grain = card, grain
        self.specimen = grain_from_card(card, grain) if specimen is None else specimen
        O.reset()
        O.trackEnergy = True
        axis = card.dimension - 1
        bottom, top = self._platens(axis)
        self.ids = insert(self.specimen, grain_material(card), first_grain=grain)
        crush = card.crush
        self.engines = GrainEngines(crush.loop, crush.damping, crush.time_step_safety)
        self.platens = CrushingPlatens(
            bottom=bottom,
            top=top,
            axis=axis,
            control=crush.control,
            speed=crush.speed,
            forceRate=crush.force_rate or 0,
            peakDrop=crush.peak_drop,
            endDrop=crush.end_drop,
            maxStrain=crush.max_strain,
            recordInterval=crush.record_interval,
            ledger=self.engines.ledger,
        )
        self.bonds = self.engines.bond(self.specimen)
        self.before = snapshot(self.specimen, self.ids)
        self.engines.start([self.platens])

    def _platens(self, axis: int) -> list[int]:
        """Walls that touch the lowest and the highest element."""
        height, radius = self.specimen.position[:, axis], self.specimen.radius
        O.materials.append(platen_material(self.card))
        walls = [
            utils.wall(float(position), axis=axis, material="platen")
            for position in ((height - radius).min(), (height + radius).max())
        ]
        for wall in walls:
            # Otherwise NewtonIntegrator books damping of their prescribed motion as lost energy.
            wall.state.isDamped = False
        return list(O.bodies.append(walls))

    def run(self) -> CrushingResult:
        """Runs the test to its end, with the interpreter free to do other things."""
        O.run(-1, True)
        return self.result()

    def result(self) -> CrushingResult:
        """What the test has given so far."""
        p = self.platens
        columns = (
            p.recordTime,
            p.recordClosing,
            p.recordForce,
            p.recordTension,
            p.recordShear,
            p.recordWork,
            p.recordElastic,
            p.recordKinetic,
            p.recordReleased,
            p.recordSliding,
            p.recordDamped,
        )
        plane = self.card.dimension == 2
        return CrushingResult(
            grain=self.grain,
            gap=p.initialGap,
            area=p.initialGap * (self.card.thickness if plane else p.initialGap),
            peak_force=p.peakForce,
            peak_closing=p.peakClosing,
            max_force=p.maxForce,
            max_closing=p.maxForceClosing,
            ended=p.ended,
            bonds=self.bonds,
            tension_breaks=self.engines.ledger.tensionBreaks,
            shear_breaks=self.engines.ledger.shearBreaks,
            record=Record(dict(zip(UNITS, map(np.array, columns))), UNITS),
            before=self.before,
            after=snapshot(self.specimen, self.ids),
            specimen=self.specimen,
        )


def crush(card: Card, grain: int = 0) -> CrushingResult:
    """Crushes one grain of the card in this process; see `crush_group` for many."""
    return CrushingTest(card, grain).run()
