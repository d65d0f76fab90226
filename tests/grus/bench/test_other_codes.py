"""LAMMPS and ESyS-Particle compute the block that Grus computes; skipped where they are not installed."""

import os
import re
import time

import psutil
import pytest
from blocks import SPHERES

from grus.bench.block import block
from grus.bench.cases import LOOPS
from grus.bench.esys_particle import Esys
from grus.bench.lammps import LOOP_TIME, Lammps
from grus.bench.measure import loops
from grus.errors import GrusError

needs_lammps = pytest.mark.skipif(not Lammps.installed(), reason="needs Debian's lammps")
needs_esys = pytest.mark.skipif(not Esys.installed(), reason="needs Debian's esys-particle")
BOTH = [
    pytest.param(Lammps, marks=needs_lammps, id="lammps"),
    pytest.param(Esys, marks=needs_esys, id="esys"),
]


@pytest.mark.parametrize("case", SPHERES, ids=lambda case: case.name)
@pytest.mark.parametrize("code", BOTH)
def test_it_has_the_elements_and_bonds_of_the_block(code, case):
    specimen = block(case)
    worker = code(case)
    try:
        worker.ready()
        assert worker.run(worker.steps) > 0
    finally:
        worker.close()
    assert worker.size == {"elements": specimen.element_count, "bonds": len(specimen.bonds())}
    assert worker.process.returncode is not None
    assert not os.path.exists(worker.folder.name)


@needs_lammps
@pytest.mark.parametrize("case", SPHERES, ids=lambda case: case.name)
def test_all_pairs_of_lammps_touch_as_long_as_they_are_measured(case):
    worker = Lammps(case)
    try:
        worker.ready()
        for _ in range(10):
            worker.run(worker.steps)
        worker.say("compute touching all contact/atom")
        worker.say("compute all all reduce sum c_touching")
        worker.say("thermo_style custom step c_all")
        worker.say("run 0 post no")
        worker.say('print "both sides: $(c_all)"')
        found = worker.until(re.compile(r"both sides: (\d+)"))
    finally:
        worker.close()
    assert int(found[1]) == 2 * worker.size["bonds"]


def test_time_is_read_from_the_words_of_lammps():
    found = LOOP_TIME.match("Loop time of 0.068796 on 1 procs for 100 steps with 1880 atoms\n")
    assert (float(found[1]), int(found[2])) == (0.068796, 1880)


@needs_esys
def test_waiting_esys_keeps_no_core_busy():
    worker = Esys(SPHERES[0])
    try:
        worker.ready()
        ranks = psutil.Process(worker.process.pid).children()
        assert len(ranks) == 2
        assert any(_comes_to_a_stop(rank) for rank in ranks)
    finally:
        worker.close()
    assert not any(rank.is_running() and rank.status() != psutil.STATUS_ZOMBIE for rank in ranks)


def _comes_to_a_stop(rank: psutil.Process) -> bool:
    """It stops itself after its answer, a moment later on a busy machine."""
    for _ in range(50):
        if rank.status() == psutil.STATUS_STOPPED:
            return True
        time.sleep(0.1)
    return False


def test_absent_programs_are_left_out(monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))
    assert loops(SPHERES[0]) == list(LOOPS)


@pytest.mark.parametrize("code, program", [(Lammps, "lmp"), (Esys, "mpirun")])
def test_a_program_that_fails_is_told_with_its_last_words(code, program, monkeypatch, tmp_path):
    fake = tmp_path / program
    fake.write_text("#!/bin/sh\necho ERROR: a library is missing\n")
    fake.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}:{os.environ['PATH']}")
    worker = None
    try:
        with pytest.raises(GrusError, match="2d_150_spheres_1 ended early: ERROR: a library"):
            worker = code(SPHERES[0])
            worker.ready()
    finally:
        if worker:
            worker.close()
