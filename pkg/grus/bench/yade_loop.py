"""Loops in YADE."""

import json
import sys
from dataclasses import asdict

from grus.bench.cases import SUBSTEPS, Case
from grus.bench.worker import STEPS, Worker


class Yade(Worker):
    """One of YADE's or Grus's laws."""

    def __init__(self, case: Case, loop: str) -> None:
        tuned = {"GLIBC_TUNABLES": "glibc.malloc.hugetlb=1"} if loop.endswith("_tuned") else {}
        script = [sys.executable, "-P", "-m", "grus.bench.yade_script"]
        unit = SUBSTEPS if loop == "grainloop" else STEPS
        super().__init__(case, loop, [*script, json.dumps(asdict(case)), loop], tuned, unit)
