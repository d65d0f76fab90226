"""Grus's classes under YADE's own MPI: a block that is split among workers is torn as on one rank."""

import json
import os
import shutil
import subprocess
from functools import lru_cache
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
BLOCK = Path(__file__).with_name("mpi_block.py")
MPIEXEC = "mpiexec --allow-run-as-root --oversubscribe --mca mpi_yield_when_idle 1 -n"


def ran(command: list, kind: str, file: Path) -> list[dict]:
    """What each rank has."""
    done = subprocess.run(
        [*command, "yade", "-n", "-x", BLOCK, kind, file],
        env=os.environ | {"PYTHONPATH": str(ROOT / "pkg"), "OMP_NUM_THREADS": "1"},
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=400,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return json.loads(file.read_text())


def pairs(parts: list[dict], name: str) -> set[tuple]:
    """Of all ranks; what crosses a boundary is known to both sides."""
    return {tuple(pair) for part in parts for pair in part[name]}


@pytest.fixture(scope="module")
def on_one_rank(tmp_path_factory):
    @lru_cache
    def of(kind: str) -> list[dict]:
        return ran([], kind, tmp_path_factory.mktemp("one") / "result.json")

    return of


@pytest.mark.skipif(not shutil.which("mpiexec"), reason="mpiexec missing: openmpi-bin")
@pytest.mark.parametrize("ranks, kind", [(2, "elements"), (3, "elements"), (3, "clumps")])
def test_split_block_is_torn_as_a_whole_one(ranks, kind, on_one_rank, tmp_path):
    whole = on_one_rank(kind)
    split = ran([*MPIEXEC.split(), str(ranks)], kind, tmp_path / "split.json")
    assert len(split) == ranks
    for name in ("made", "bonds", "broken"):
        assert pairs(split, name) == pairs(whole, name)
    assert len(pairs(whole, "bonds")) > 50 and len(pairs(whole, "broken")) > 50
    states = {body: state for part in split for body, state in part["states"].items()}
    assert states == whole[0]["states"]
    if ranks > 2:
        both = [set(map(tuple, part["broken"])) for part in split[1:]]
        assert both[0] & both[1]  # bonds between workers, which broke on both sides
