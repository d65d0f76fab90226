# Loads the specimen of a card in an oedometer, stage by stage. From the top folder of Grus:
#     PYTHONPATH=pkg yade -n -x scripts/oedometer.py models/quick.toml [FOLDER]
# `grus oedometer` does the same; besides, it goes on where it was cut off, and writes a report.
from math import atan

import numpy as np

import grus  # makes Grus's classes known to YADE; from here on they stand beside YADE's own
from grus.oedometer.run import SEATING
from grus.oedometer.test import record
from grus.preparation import prepare
from grus.preparation.press import element_stiffness
from grus.preparation.walls import add_walls
from grus.scene import CALMING, GrainEngines, grain_material, insert, set_damping, snapshot
from grus.scene.vtk import write_vtk
from grus.script import arguments

card, folder = arguments(folder=".")  # or from a table of yade-batch
test = card.oedometer

# Grains at rest in a box, as plain arrays: from the folder if they are there, else made as scripts/prepare.py does.
prepared = prepare(card, folder, print)
specimen = prepared.specimen
print(f"{specimen.grain_count} grains, void ratio {prepared.void_ratio:.4f}")

# The box and the grains. Walls across each axis; the last axis is that of loading.
O.reset()
O.trackEnergy = True  # for the energy that damping takes out
rock = grain_material(card)
stiffness = test.wall_stiffness or element_stiffness(rock, card.element.radius)
smooth = atan(test.wall_friction)
steel = BondMat(kn=stiffness, ks=stiffness, frictionAngle=smooth, thickness=rock.thickness)
*sides, (bottom, top) = add_walls(prepared.lower, prepared.upper, steel)
elements = insert(specimen, rock)

# The engines. The servo moves both platens so that the stress on each goes to a target, and tells when all is at rest.
engines = GrainEngines(test.loop, test.damping, test.time_step_safety)
size = prepared.upper - prepared.lower
servo = OedometerServo(
    bottom=bottom,
    top=top,
    sides=sum(sides, []),
    axis=card.dimension - 1,
    area=float(np.prod(size[:-1])) * (card.thickness or 1),
    sideBreadth=card.thickness if card.dimension == 2 else float(np.mean(size[:2])),
    solidVolume=prepared.outline_volume,
    ledger=engines.ledger,
    maxSpeed=test.speed,  # of a platen while bonds break [m/s]
    fastSpeed=test.fast_speed or 0,  # while nothing happens
    tolerance=test.tolerance,
    unbalancedLimit=test.unbalanced_limit,
    quietSteps=test.quiet_steps,
    inertialLimit=test.inertial_limit,
    recordStrain=test.record_strain,
    recordStress=test.record_stress,
    grainDiameter=float(specimen.grain_diameter.mean()),
    grainDensity=card.element.density,
)
print(f"{engines.bond(specimen)} bonds")
engines.start([servo])
engines.quench()  # grains settle on the contacts that are found again

# The stages. `begin` sets a target, and the servo ends the run when the specimen rests there.
targets = [card.preparation.seating_stress]
for stage in test.stages:
    targets.append(targets[-1] if stage.stress is None else stage.stress)
for number, target in enumerate(targets):
    servo.tolerance = test.tolerance if number else SEATING
    set_damping(test.damping if number else CALMING)
    servo.begin(target)
    O.run(-1, True)
    strain, breaks = f"{100 * servo.strain:.4f} %", engines.ledger.breaks
    print(
        f"{target / 1e3:g} kPa: strain {strain}, void ratio {servo.voidRatio:.6f}, {breaks} bonds broken"
    )
    write_vtk(f"{folder}/stage-{number:03d}.vtp", specimen, snapshot(specimen, elements))
record().frame().to_csv(f"{folder}/record.csv", index=False)
