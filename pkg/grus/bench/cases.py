"""What is measured: blocks of bonded elements, and the loops that compute them."""

from collections.abc import Sequence
from dataclasses import dataclass

LOOPS = {
    "cohfrict_moments": "YADE CohFrict with moments",
    "cohfrict_moments_tuned": "the same, tuned",
    "jcfpm": "YADE JCFpm",
    "law2": "Grus Law2 in InteractionLoop",
    "grainloop": "Grus GrainLoop",
}
# They know no clumps, and take part with one thread.
OTHER_CODES = {"lammps": "LAMMPS granular", "esys": "ESyS-Particle RotBond"}
SUBSTEPS = 500  # of GrainLoop in a YADE step

DIMENSIONS = (2, 3)
ELEMENTS = (1_000, 10_000, 50_000, 150_000)
KINDS = ("spheres", "clumps")
THREADS = (1, 2)


@dataclass(frozen=True)
class Case:
    """A block of bonded elements in closest packing.

    dimension: 2 (discs) or 3 (spheres). elements: about how many. stamped: whether clumps of about 7 are stamped.
    threads: of the loop.
    """

    dimension: int
    elements: int
    stamped: bool
    threads: int = 1

    @property
    def name(self) -> str:
        kind = "clumps" if self.stamped else "spheres"
        return f"{self.dimension}d_{self.elements}_{kind}_{self.threads}"

    @property
    def loops(self) -> dict[str, str]:
        """Names and titles of the loops that can compute it."""
        return LOOPS if self.stamped or self.threads > 1 else LOOPS | OTHER_CODES


def cases(
    dimensions: Sequence[int] = DIMENSIONS,
    elements: Sequence[int] = ELEMENTS,
    kinds: Sequence[str] = KINDS,
    threads: Sequence[int] = THREADS,
) -> list[Case]:
    """All combinations, each once; kinds: of "spheres", which are free, and "clumps"."""
    found = [
        Case(dimension, count, kind == "clumps", number)
        for dimension in dimensions
        for kind in kinds
        for count in elements
        for number in threads
    ]
    return list(dict.fromkeys(found))


FULL = cases()
QUICK = [Case(2, 3_000, True), Case(3, 3_000, True), Case(3, 1_000, False)]
