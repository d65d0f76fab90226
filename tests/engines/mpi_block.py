"""A bonded block that is torn, on one rank or split among the workers of `yade.mpy`. Run by yade, alone or under mpiexec.

Arguments: "elements" or "clumps" of two; file for the result, a list with what each rank has.
"""

import json
import os
import sys
from math import sqrt

import grus  # noqa: F401
from yade import O, utils
from yade.wrapper import (
    Bo1_Sphere_Aabb,
    BondLedger,
    BondMat,
    ForceResetter,
    Ig2_Sphere_Sphere_ScGeom,
    InsertionSortCollider,
    InteractionLoop,
    InteractionSorter,
    Ip2_BondMat_BondMat_BondPhys,
    Law2_ScGeom_BondPhys_Bonded,
    NewtonIntegrator,
)

RADIUS, COLUMNS, ROWS = 1e-3, 10, 8
STEPS, DT = 300, 5e-9
kind, file = sys.argv[1:]
ranks = int(os.environ.get("OMPI_COMM_WORLD_SIZE", 1))


def insert() -> None:
    """Discs in closest packing, of which half go to each worker; rank 0 has none."""
    rock = BondMat(
        density=2000,
        kn=1e9,
        ks=1e9,
        frictionAngle=0.46,
        thickness=1,
        bond="parallel",
        bondStiffness="total",
        bondKn=1e9,
        bondKs=1e9,
        tensileStrength=3e5,
        shearStrength=3e5,
    )
    O.materials.append(rock)
    discs = [
        utils.sphere(
            ((2 * i + j % 2 - COLUMNS) * RADIUS, sqrt(3) * j * RADIUS, 0),
            RADIUS,
            material=rock,
            color=(1, 1, 1),
        )
        for j in range(ROWS)
        for i in range(COLUMNS)
    ]
    if kind == "clumps":
        for first in range(0, len(discs), 2):
            O.bodies.appendClumped(discs[first : first + 2])
    else:
        O.bodies.append(discs)
    for number, disc in enumerate(discs):
        disc.state.grain, disc.state.element = 0, number
    for body in O.bodies:
        x, y, _ = O.bodies[body.clumpId].state.pos if body.isClumpMember else body.state.pos
        body.state.vel = (1500 * x + 600 * y, 1000 * y, 0)
        if not body.isClumpMember:
            body.state.blockedDOFs = "zXY"
        if ranks > 1:
            body.subdomain = 1 if x < 0 or ranks == 2 else 2


def engine(name: str) -> object:
    """That of the current scene: splitting replaces the scene of each worker."""
    return next(one for one in O.engines if type(one).__name__ == name)


def set_bonding(on: bool) -> None:
    loop, reach = engine("InteractionLoop"), 1.01 if on else 1
    loop.physDispatcher.functors[0].bonding = on
    loop.geomDispatcher.functors[0].interactionDetectionFactor = reach
    engine("InsertionSortCollider").boundDispatcher.functors[0].aabbEnlargeFactor = reach


def run(steps: int) -> None:
    if ranks == 1:
        O.run(steps, True)
    else:
        mpy.mpirun(steps)


def outcome() -> dict:
    """Bonds of this rank, those that broke, and state of the bodies that are its own."""
    ledger, own = engine("BondLedger"), 0 if ranks == 1 else mpy.rank
    pairs = [(i.id1, i.id2) for i in O.interactions if i.isReal and i.phys.bonded]
    return {
        "bonds": [sorted(pair) for pair in pairs],
        "broken": [sorted(pair) for pair in zip(ledger.brokenId1, ledger.brokenId2)],
        "states": {
            b.id: [*b.state.pos, *b.state.vel, *b.state.angVel]
            for b in O.bodies
            if b.subdomain == own and not b.isSubdomain
        },
    }


if ranks > 1:
    from yade import mpy
insert()
ledger = BondLedger()
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()], label="collider", verletDist=0.2 * RADIUS),
    InteractionSorter(),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom()],
        [Ip2_BondMat_BondMat_BondPhys()],
        [Law2_ScGeom_BondPhys_Bonded(ledger=ledger)],
    ),
    ledger,
    NewtonIntegrator(gravity=(0, 0, 0), damping=0.1),
]
O.dt = 0
if ranks > 1:
    # A step without interactions splits the scene, which would cut bonds between workers. What a worker got from another
    # one has materials of its own, and only elements of one material are bonded.
    engine("InteractionLoop").dead = True
    mpy.mpirun(1)
    engine("InteractionLoop").dead = False
    for body in O.bodies:
        if not body.isSubdomain and body.material is not None:
            body.material = O.materials[0]
set_bonding(True)
run(1)
set_bonding(False)
O.dt = DT
made = outcome()["bonds"]
run(STEPS)
here = outcome() | {"made": made}
parts = [here] if ranks == 1 else mpy.comm.gather(here, root=0)
if parts is not None:
    with open(file, "w") as out:
        json.dump(parts, out)
