"""A block in ESyS-Particle, timed whenever it is asked: `esysparticle esys_particle_script.py BLOCK.npz`, for `Worker`.

The interpreter is ESyS-Particle's: nothing of Grus is imported.
"""

import json
import os
import signal
import sys
import time
from pathlib import Path

import numpy as np


def stop(kind: type, error: BaseException, *_: object) -> None:
    """Says what went wrong and breaks off, so that mpirun ends the worker too; it would wait for ever."""
    print(f"{kind.__name__}: {error}", flush=True)
    os._exit(1)


sys.excepthook = stop

from esys.lsm import (
    InteractionScalarFieldSaverPrms,
    LsmMpi,
    RotBondPrms,
)
from esys.lsm.geometry import SimpleSphere, TaggedIdConnection
from esys.lsm.util import BoundingBox, Vec3

TAGS = 64  # groups of elements that share a velocity; one call an element would take long
COUNT = "count"


def build(block: dict[str, np.ndarray], folder: Path) -> LsmMpi:
    """The block, bonded and moving; the number of its bonds is written into `folder` at the first step."""
    size = float(block["radius"].max())
    skin = float(block["skin"])
    simulation = LsmMpi(1, [1, 1, 1])
    # Its second length is the way that an element may go; both together use up the skin.
    simulation.initNeighbourSearch("RotSphere", 2 * size + 2 * skin, skin / 2)
    simulation.setTimeStepSize(float(block["time_step"]))
    reach = float(np.abs(block["position"]).max()) + 8 * size
    flat = 2 * size if block["dimension"] == 2 else reach
    simulation.setSpatialDomain(BoundingBox(Vec3(-reach, -reach, -flat), Vec3(reach, reach, flat)))
    simulation.force2dComputations(bool(block["dimension"] == 2))
    simulation.createParticles(
        [
            SimpleSphere(Vec3(*place), radius, number, number % TAGS)
            for number, (place, radius) in enumerate(
                zip(block["position"].tolist(), block["radius"].tolist())
            )
        ]
    )
    for tag, velocity in enumerate(block["velocity"][:TAGS].tolist()):
        simulation.setParticleDensity(tag, -1, float(block["density"]))
        simulation.setTaggedParticleVelocity(tag, Vec3(*velocity))
    simulation.createConnections(
        [TaggedIdConnection(one, two, 0) for one, two in block["bonds"].tolist()]
    )
    stiffness, bending = float(block["stiffness"]), float(block["bending_stiffness"])
    strengths = 4 * [float(block["strength"])]
    simulation.createInteractionGroup(
        RotBondPrms("bonds", stiffness, stiffness, bending, bending, *strengths, 0, False)
    )
    simulation.createFieldSaver(
        InteractionScalarFieldSaverPrms("bonds", COUNT, str(folder / COUNT), "SUM", 0, 0, 1)
    )
    return simulation


def siblings() -> list[int]:
    """Processes that mpirun has started beside this one."""
    parent = os.getppid()
    children = Path(f"/proc/{parent}/task/{parent}/children").read_text().split()
    return [int(child) for child in children if int(child) != os.getpid()]


def main() -> None:
    """Answers each number of steps on standard input with the seconds that they took."""
    path = Path(sys.argv[1])
    simulation = build(dict(np.load(path)), path.parent)
    simulation.runTimeStep()
    bonds = int(float((path.parent / COUNT).read_text().split()[-1]))
    elements = simulation.getNumParticles()
    print(json.dumps({"elements": elements, "bonds": bonds}), flush=True)
    others = siblings()

    def tell(sign: int) -> None:
        for other in others:
            os.kill(other, sign)

    # A worker that waits for its next command computes nothing, but keeps a core busy with asking.
    tell(signal.SIGSTOP)
    for line in sys.stdin:
        tell(signal.SIGCONT)
        start = time.perf_counter()
        for _ in range(int(line)):
            simulation.runTimeStep()
        print(time.perf_counter() - start, flush=True)
        tell(signal.SIGSTOP)
    tell(signal.SIGCONT)
    simulation.exit()


main()
