"""Which limit of the adaptive speed is passed on the way to a stress, and how often."""

import numpy as np
from grus.oedometer.program import program
from grus.oedometer.run import SEATING
from grus.oedometer.test import OedometerTest, record, servo
from grus.preparation import prepare
from tests import FAST, READINGS, RESULTS, card
from yade import O

SEED, STAGES = 2, 4


def main() -> None:
    model = card(SEED)
    OedometerTest(model, prepare(model, RESULTS / "specimens"))
    control = servo()
    for attribute, value in (READINGS | {"fastSpeed": FAST}).items():
        setattr(control, attribute, value)
    for number, stage in enumerate(program(model)[:STAGES]):
        control.tolerance = SEATING if number == 0 else model.oedometer.tolerance
        control.begin(stage.stress)
        O.run(-1, True)
    found = record()
    axial = (found["top_stress"] + found["bottom_stress"]) / 2
    for number, stage in enumerate(program(model)[1:STAGES], start=1):
        way = (found["stage"] == number) & (abs(axial / stage.stress - 1) > control.tolerance)
        gap = abs(found["top_stress"] - found["bottom_stress"])
        shown = {
            "kinetic over elastic energy": (
                found["kinetic_energy"] / found["elastic_energy"],
                control.kineticLimit,
            ),
            "inertial number": (found["inertial_number"], control.inertialLimit),
            "stress gradient": (gap / axial, control.gradientLimit),
        }
        print(f"to {stage.stress / 1e3:g} kPa, at most {found['speed_limit'][way].max():.3g} m/s")
        for name, (values, limit) in shown.items():
            print(f"  {name}: median {np.median(values[way]):.2g}, ", end="")
            print(f"{(values[way] > limit).mean():.0%} of the readings above {limit:g}")


if __name__ == "__main__":
    main()
