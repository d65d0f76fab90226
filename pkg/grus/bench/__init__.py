"""How long a step takes: Grus's loops beside YADE's own laws and other codes on the same block of bonded grains."""

from grus.bench.bench import bench
from grus.bench.cases import FULL, QUICK, Case, cases
from grus.bench.measure import Timing, measure
from grus.bench.report import print_table, summary
from grus.bench.store import read, write

__all__ = [
    "FULL",
    "QUICK",
    "Case",
    "Timing",
    "bench",
    "cases",
    "measure",
    "print_table",
    "read",
    "summary",
    "write",
]
