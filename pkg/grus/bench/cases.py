"""What is measured: blocks of bonded elements, and the loops that compute them."""

from dataclasses import dataclass

LOOPS = {
    "cohfrict_moments": "YADE CohFrict with moments",
    "cohfrict_moments_tuned": "the same, tuned",
    "jcfpm": "YADE JCFpm",
    "law2": "Grus Law2 in InteractionLoop",
    "grainloop": "Grus GrainLoop",
}
SUBSTEPS = 500  # of GrainLoop in a YADE step


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


FULL = [
    Case(dimension, elements, stamped, threads)
    for dimension in (2, 3)
    for stamped in (False, True)
    for elements in (1_000, 10_000, 50_000, 150_000)
    for threads in (1, 2)
]
QUICK = [Case(2, 3_000, True), Case(3, 3_000, True)]
