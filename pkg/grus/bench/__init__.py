"""How long a step takes: Grus's loops beside YADE's own laws on the same block of bonded grains."""

from grus.bench.cases import FULL, QUICK, Case
from grus.bench.measure import Timing, measure
from grus.bench.report import print_table, summary, write

__all__ = ["FULL", "QUICK", "Case", "Timing", "measure", "print_table", "summary", "write"]
