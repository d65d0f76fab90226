"""One oedometer test of one specimen in YADE."""

from pathlib import Path

import numpy as np

from curve import Curve
from dem import contacts
from dem.holds import HOLDS
from dem.scene import O, Specimen
from dem.servo import Servo
from programs import SEATING, Stage, stages

SPEED = 0.05  # of the platen [m/s]
LOOK = 200  # steps between two rows
PACKED = 0.38  # void ratio that grains without friction are packed to
PACKING = 3000.0  # or the stress at which they are dense enough [kPa]
SETTLING = 16  # stretches at most, before the test
WAITING = 0.03  # share of a ramp's time that belongs to the rest at its end


class Test:
    """base: `stiffness`, `strength` (factors), `friction`, `element` [m]. effects: name -> parameters."""

    def __init__(self, base: dict[str, float], effects: dict, seed: int, store: Path):
        self.effects, self.rows, self.clock, self.stage = effects, [], 0.0, 0
        self.specimen = prepared(base, seed, store)
        speed = effects.get("loading_too_fast", {}).get("speed", SPEED)
        self.servo = Servo(self.specimen, base["stiffness"], SPEED)
        walls = effects.get("wall_friction", {}).get("friction", 0.0)
        rolling = effects.get("rolling_resistance", {}).get("rolling", 0.0)
        self.specimen.begin(base["strength"], base["friction"], walls, rolling)
        if "strength_scatter" in effects:
            self.specimen.scatter_strength(effects["strength_scatter"]["variation"], seed)
        if "hertzian_contact" in effects:
            self.contacts = contacts.Hertzian(self.specimen, effects["hertzian_contact"]["force"])
        if "contact_plasticity" in effects:
            self.contacts = contacts.Plastic(self.specimen, effects["contact_plasticity"]["ratio"])
        self.servo.aim(1e3 * SEATING)
        self.servo.rest(most=SETTLING)
        self.servo.speed = speed
        self.height = self.specimen.height
        self.row(0.0)

    def row(self, time: float, shown: float | None = None) -> None:
        """shown: stress of the gauge [kPa] where it is not that of the platen."""
        top, base, lateral = (1e-3 * s for s in self.specimen.stresses())
        strain = 1 - self.specimen.height / self.height
        events = self.specimen.breaks()
        shown = top if shown is None else shown
        self.clock = max(self.clock, time)
        self.rows.append((self.clock, shown, strain, base, lateral, events, self.stage))

    def ramp(self, stage: Stage, begin: float) -> None:
        """The clock of a ramp follows the stress, since a laboratory raises it evenly."""
        self.servo.aim(1e3 * stage.end)

        def row() -> None:
            done = (1e-3 * self.specimen.stresses()[0] - stage.start) / (stage.end - stage.start)
            share = min(max(done, 0.0), 1.0) * (1 - WAITING)
            self.row(begin + stage.hours * share)

        while not self.servo.reached():
            O.run(LOOK, True)
            row()
        self.servo.rest(row)
        self.row(begin + stage.hours)

    def hold(self, stage: Stage, begin: float) -> None:
        self.row(begin + 1e-3 * stage.hours)
        for name, given in self.effects.items():
            if name in HOLDS and given.get("stage", self.stage) == self.stage:
                leaks = name == "load_leak"

                def row(time: float, shown: float | None = stage.end if leaks else None) -> None:
                    self.row(time, shown)

                HOLDS[name](self.specimen, self.servo, stage.hours, begin, row, given)
                return
        self.servo.rest()
        self.row(begin + stage.hours)

    def run(self, program: str) -> Curve:
        begin = 0.0
        for self.stage, stage in enumerate(stages(program)):
            (self.hold if stage.hold else self.ramp)(stage, begin)
            begin += stage.hours
            print(self.stage, O.iter, self.rows[-1], flush=True)
        table = np.array(self.rows).T
        others = dict(zip(("base_stress", "lateral_stress", "ae_events"), table[3:6], strict=True))
        return Curve(table[0], table[1], table[2], table[6].astype(int), others)


def prepared(base: dict[str, float], seed: int, store: Path) -> Specimen:
    """The specimen under the seating stress, from the store if it was made before."""
    path = store / f"specimen-{seed}-{base['stiffness']:g}-{1e6 * base['element']:g}.yade.gz"
    if not path.exists():
        specimen = Specimen(base["stiffness"], base["element"], seed)
        servo = Servo(specimen, base["stiffness"], SPEED)
        servo.pack(PACKED, 1e3 * PACKING)
        servo.speed = SPEED
        servo.aim(1e3 * SEATING)
        servo.rest(most=SETTLING)
        O.engines = O.engines[:4]
        store.mkdir(parents=True, exist_ok=True)
        specimen.save(path)
    return Specimen.load(path, base["element"])
