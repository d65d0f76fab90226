"""The block in ESyS-Particle: elements joined by its rotational bonds."""

import shutil
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from grus.bench.block import (
    DENSITY,
    RADIUS,
    SKIN,
    STIFFNESS,
    UNBREAKABLE,
    block,
    time_step,
    velocities,
)
from grus.bench.cases import Case
from grus.bench.worker import Worker

SCRIPT = Path(__file__).with_name("esys_particle_script.py")
# A master and a worker, as few as it can do with. Waiting ranks give way to others.
MPIRUN = (
    "mpirun --quiet --allow-run-as-root --oversubscribe --bind-to none --mca mpi_yield_when_idle 1"
)
PROGRAMS = ("esysparticle", "mpirun")


class Esys(Worker):
    """ESyS-Particle with one worker process."""

    def __init__(self, case: Case, loop: str = "esys") -> None:
        self.folder = TemporaryDirectory(prefix="grus-bench-")
        data = Path(self.folder.name, "block.npz")
        write_data(case, data)
        super().__init__(case, loop, [*MPIRUN.split(), "-n", "2", "esysparticle", SCRIPT, data])

    @staticmethod
    def installed() -> bool:
        """Whether ESyS-Particle and the MPI that it needs can be called."""
        return all(map(shutil.which, PROGRAMS))

    def close(self) -> None:
        """Ends the process, whatever it is doing."""
        super().close()
        self.folder.cleanup()


def write_data(case: Case, path: Path) -> None:
    """Writes the block with all that the script needs to know of it; in SI."""
    specimen = block(case)
    np.savez(
        path,
        dimension=specimen.dimension,
        position=specimen.position,
        radius=specimen.radius,
        bonds=specimen.bonds(),
        velocity=velocities(specimen.element_count, specimen.dimension),
        density=DENSITY,
        stiffness=STIFFNESS,
        bending_stiffness=STIFFNESS * RADIUS**2,
        strength=UNBREAKABLE,
        skin=SKIN,
        time_step=time_step(specimen.dimension),
    )
