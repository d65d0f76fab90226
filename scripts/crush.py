# Crushes one grain of a card between two platens, with every engine in sight. From the top folder of Grus:
#     PYTHONPATH=pkg yade -n -x scripts/crush.py models/montesinho.toml [NUMBER OF THE GRAIN [FOLDER]]
# `grus crush` does the same with a group of grains. Change what you like, or take the script apart.
import pandas as pd

import grus  # makes Grus's classes known to YADE; from here on they stand beside YADE's own
from grus.scene import grain_material, insert, platen_material, snapshot
from grus.script import arguments
from grus.specimen.from_card import grain_from_card

card, number, folder = arguments(grain=0, folder=None)  # or from a table of yade-batch

# The grain: elements in a regular packing, which a stamp gathers into rigid clumps. Plain arrays, no YADE so far.
grain = grain_from_card(card, number)

# Platens that touch the grain from below and above, then the grain. Both materials are BondMat.
rock, steel = grain_material(card), platen_material(card)
axis = card.dimension - 1  # of loading: y in the plane, z in space
O.materials.append(steel)
low = float((grain.position[:, axis] - grain.radius).min())
high = float((grain.position[:, axis] + grain.radius).max())
bottom, top = O.bodies.append([utils.wall(at, axis=axis, material=steel) for at in (low, high)])
for wall in (bottom, top):
    O.bodies[wall].state.isDamped = False  # their motion is prescribed
elements = insert(grain, rock, first_grain=number)  # ids of the bodies, in their order

# One step of YADE's usual loop, without time, makes the bonds. Elements touch exactly, so they are looked for a little
# further out.
bounds, contacts = Bo1_Sphere_Aabb(), Ig2_Sphere_Sphere_ScGeom()
bonds, ledger = Ip2_BondMat_BondMat_BondPhys(bonding=True), BondLedger()
law = Law2_ScGeom_BondPhys_Bonded(ledger=ledger)
bounds.aabbEnlargeFactor = contacts.interactionDetectionFactor = 1.01
O.engines = [
    ForceResetter(),
    InsertionSortCollider([bounds, Bo1_Wall_Aabb()]),
    InteractionSorter(),
    InteractionLoop([contacts, Ig2_Wall_Sphere_ScGeom()], [bonds], [law]),
    ledger,
    NewtonIntegrator(gravity=(0, 0, 0)),
]
O.dt = 0
O.step()
made = sum(i.phys.bonded for i in O.interactions)
assert made == len(grain.bonds())
print(f"{grain.element_count} elements in {grain.clump_count} clumps, {made} bonds")

# The test. GrainLoop takes the place of the usual loop and is some ten times as fast; CrushingPlatens moves the platens
# and stops the run when the force has dropped for good.
platens = CrushingPlatens(
    bottom=bottom,
    top=top,
    axis=axis,
    speed=card.crush.speed,  # at which they close in on each other [m/s]
    peakDrop=card.crush.peak_drop,  # the grain has crushed when the force falls by this share
    endDrop=card.crush.end_drop,
    maxStrain=card.crush.max_strain,
    recordInterval=card.crush.record_interval,
    ledger=ledger,
)
stepper = BondTimeStepper(safety=card.crush.time_step_safety, timeStepUpdateInterval=1000)
loop = GrainLoop(substeps=1000, damping=card.crush.damping, ledger=ledger, loading=[platens])
O.trackEnergy = True
O.engines = [stepper, loop]
O.dt = stepper.safety * stepper.critical()
O.run(-1, True)

# What came out.
area = platens.initialGap * (card.thickness or platens.initialGap)
strength = (platens.peakForce or platens.maxForce) / area
print(f"ended: {platens.ended}, after {O.iter} steps of about {O.dt:.2g} s")
print(f"peak force {platens.peakForce / 1e3:.4g} kN, strength {strength / 1e6:.7g} MPa")
print(f"{ledger.tensionBreaks} bonds broken in tension, {ledger.shearBreaks} in shear")
print(f"{snapshot(grain, elements).fragment_count} fragments")
if folder:
    curve = {"closing [m]": platens.recordClosing, "force [N]": platens.recordForce}
    pd.DataFrame(curve).to_csv(f"{folder}/curve.csv", index=False)
