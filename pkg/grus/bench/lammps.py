"""The block in LAMMPS: granular elements with friction, rolling and twisting resistance."""

import math
import re
import shutil
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from grus.bench.block import DENSITY, RADIUS, SKIN, STIFFNESS, block, time_step, velocities
from grus.bench.cases import Case
from grus.bench.worker import Worker
from grus.specimen import Specimen, element_volume

# Contacts of LAMMPS cannot pull: elements are larger by this share, so that all pairs touch from the beginning, and
# time runs so slowly that none parts while it is measured. How long a step takes depends on neither.
OVERLAP = 1e-4
SLOWER = 1e-6

FRICTION = 0.5
LOOP_TIME = re.compile(r"Loop time of (\S+) on \d+ procs for \d+ steps with (\d+) atoms")
PAIRS = re.compile(r"Total # of neighbors = (\d+)")


class Lammps(Worker):
    """LAMMPS itself, which takes its commands from standard input as they come."""

    def __init__(self, case: Case, loop: str = "lammps") -> None:
        specimen = block(case)
        self.folder = TemporaryDirectory(prefix="grus-bench-")
        data = Path(self.folder.name, "block.data")
        write_data(specimen, data)
        # Line by line, since LAMMPS would keep its answers back in a pipe.
        command = ["stdbuf", "--output=L", "lmp", "-log", "none"]
        super().__init__(case, loop, command)
        self.say("\n".join(script(specimen.dimension, data)))

    @staticmethod
    def installed() -> bool:
        """Whether LAMMPS can be called."""
        return shutil.which("lmp") is not None

    def built(self) -> dict[str, int]:
        """Atoms and pairs of neighbours as LAMMPS counts them; in closest packing all neighbours touch."""
        self.say("run 0")
        atoms = int(self.until(LOOP_TIME)[2])
        return {"elements": atoms, "bonds": int(self.until(PAIRS)[1])}

    def run(self, steps: int) -> float:
        """Seconds for so many steps, by LAMMPS's own clock."""
        self.say(f"run {steps} pre no post no")
        return float(self.until(LOOP_TIME)[1])

    def close(self) -> None:
        """Ends the process, whatever it is doing."""
        super().close()
        self.folder.cleanup()

    def until(self, pattern: re.Pattern) -> re.Match:
        """The next line that fits; others are passed over."""
        while not (found := pattern.match(self.line())):
            pass
        return found


def script(dimension: int, data: Path) -> Iterator[str]:
    """Commands that build the block of the file `data`; nothing has run yet."""
    plane = dimension == 2
    rolling = STIFFNESS * RADIUS**2
    yield "units si"
    yield f"dimension {dimension}"
    yield f"boundary f f {'p' if plane else 'f'}"
    yield "atom_style sphere"
    yield "comm_modify vel yes"
    yield f"read_data {data}"
    yield f"neighbor {SKIN} bin"
    yield "neigh_modify delay 0 every 1 check yes"
    yield "pair_style granular"
    yield (
        f"pair_coeff * * hooke {STIFFNESS} 0 tangential linear_history {STIFFNESS} 0 {FRICTION} "
        f"rolling sds {rolling} 0 {FRICTION} twisting sds {rolling} 0 {FRICTION} damping velocity"
    )
    yield f"fix motion all nve/sphere{' disc' if plane else ''}"
    if plane:
        yield "fix plane all enforce2d"
    yield f"timestep {SLOWER * time_step(dimension)}"
    yield "thermo 0"


def write_data(specimen: Specimen, path: Path) -> None:
    """Writes the elements as LAMMPS's data file, with the masses that they have in the other codes."""
    count = specimen.element_count
    number = np.arange(1, count + 1)
    diameter = 2 * (1 + OVERLAP) * specimen.radius
    density = DENSITY * element_volume(specimen) / (math.pi / 6 * diameter**3)
    reach = np.abs(specimen.position).max() + 4 * RADIUS
    reaches = (reach, reach, RADIUS if specimen.dimension == 2 else reach)
    atoms = np.column_stack([number, np.ones(count), diameter, density, specimen.position])
    still = np.zeros((count, 3))
    moving = np.column_stack([number, velocities(count, specimen.dimension), still])
    with path.open("w") as file:
        print(f"block of elements\n\n{count} atoms\n1 atom types", file=file)
        for axis, size in zip("xyz", reaches):
            print(f"{-size} {size} {axis}lo {axis}hi", file=file)
        print("\nAtoms # sphere\n", file=file)
        np.savetxt(file, atoms, fmt="%d %d" + 5 * " %.17g")
        print("\nVelocities\n", file=file)
        np.savetxt(file, moving, fmt="%d" + 6 * " %.17g")
