# Crushes one plane rockfill grain between two platens, with every engine in sight. From the top folder of Grus:
#     PYTHONPATH=pkg yade -n -x scripts/crush_one.py
# The numbers are those of models/montesinho.toml, in SI. Change them, or take the script apart.
from math import atan

import grus  # makes Grus's classes known to YADE; from here on they stand beside YADE's own
from grus.scene import insert, snapshot
from grus.specimen import Circle, Stamp, agglomerate

# The grain: discs in a regular packing, which a stamp gathers into rigid clumps. Plain arrays, no YADE so far.
stamp = Stamp(mean=1.0e-3, deviation=0.2e-3)  # radius of the stamp [m]
grain = agglomerate(Circle(12.6e-3), element_radius=0.6e-3, stamp=stamp, seed=1, grain=0)

# What grain and platens are made of. With a thickness, elements are discs in a plane; without, spheres.
rock = BondMat(
    density=2052,
    kn=3e9,  # of one element [N/m]; a contact has two of them in series
    ks=3e9,
    frictionAngle=atan(0.5),
    bond="parallel",
    bondStiffness="total",
    bondKn=3e9,  # of the whole section of a bond [N/m]
    bondKs=3e9,
    tensileStrength=1e6,  # [Pa]
    shearStrength=1e6,
    thickness=1.0,
    seed=1,
)
steel = BondMat(kn=3e10, ks=3e10, frictionAngle=atan(0.5), thickness=1.0)

# Platens that touch the grain from below and above.
O.materials.append(steel)
low = float((grain.position[:, 1] - grain.radius).min())
high = float((grain.position[:, 1] + grain.radius).max())
bottom, top = O.bodies.append([utils.wall(y, axis=1, material=steel) for y in (low, high)])
for wall in (bottom, top):
    O.bodies[wall].state.isDamped = False  # their motion is prescribed
elements = insert(grain, rock)  # ids of the bodies, in the order of grain.position

# The engines. Grus adds four to a usual loop: sorter, ledger, time step and platens.
bounds, contacts = Bo1_Sphere_Aabb(), Ig2_Sphere_Sphere_ScGeom()
bonds = Ip2_BondMat_BondMat_BondPhys()
ledger = BondLedger()
stepper = BondTimeStepper(safety=0.5)
platens = CrushingPlatens(
    bottom=bottom,
    top=top,
    axis=1,
    speed=0.01,  # at which they close in on each other [m/s]
    peakDrop=0.1,  # the grain has crushed when the force falls by 10 %
    recordInterval=1e-5,  # of the initial gap
    ledger=ledger,
)
newton = NewtonIntegrator(damping=0.2, gravity=(0, 0, 0))
loop = [
    ForceResetter(),
    InsertionSortCollider([bounds, Bo1_Wall_Aabb()]),
    InteractionSorter(),
    InteractionLoop(
        [contacts, Ig2_Wall_Sphere_ScGeom()], [bonds], [Law2_ScGeom_BondPhys_Bonded(ledger=ledger)]
    ),
    ledger,
]

# One step without time makes the bonds. Elements touch exactly, so they are looked for a little further out.
O.engines = loop + [newton]
O.dt = 0
bounds.aabbEnlargeFactor = contacts.interactionDetectionFactor = 1.01
bonds.bonding = True
O.step()
bonds.bonding = False
bounds.aabbEnlargeFactor = contacts.interactionDetectionFactor = 1
made = sum(i.phys.bonded for i in O.interactions)
assert made == len(grain.bonds())
print(f"{grain.element_count} elements in {grain.clump_count} clumps, {made} bonds")

# The test. CrushingPlatens stops the run when the force has dropped for good.
O.trackEnergy = True
O.engines = loop + [stepper, platens, newton]
O.dt = stepper.safety * stepper.critical()
O.run(-1, True)

# What came out.
area = platens.initialGap * rock.thickness
strength = (platens.peakForce or platens.maxForce) / area
spent = ledger.releasedEnergy + ledger.slidingWork + platens.recordDamped[-1]
left = platens.recordElastic[-1] + platens.recordKinetic[-1]
print(f"ended: {platens.ended}, after {O.iter} steps of about {O.dt:.2g} s")
print(f"peak force {platens.peakForce / 1e3:.4g} kN, strength {strength / 1e6:.4g} MPa")
print(f"{ledger.tensionBreaks} bonds broken in tension, {ledger.shearBreaks} in shear")
print(f"{snapshot(grain, elements).fragment_count} fragments")
print(f"work {platens.work:.4g} J: spent {spent:.4g} J, left in the grain {left:.4g} J")
