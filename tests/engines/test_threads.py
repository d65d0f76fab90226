"""Two threads add forces in another order than one: equal to round-off until bonds break, and the same to the eye after."""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

SCRIPT = """
import json
from scenes import running
from yade import O
test = running({steps})
print(json.dumps({{
    "threads": O.numThreads,
    "position": [list(b.state.pos) for b in O.bodies],
    "strength": [i.phys.strengthFactor for i in O.interactions if i.phys.bonded],
    "force": test.platens.recordForce,
}}))
"""


def run(threads: int, steps: int) -> dict:
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT.format(steps=steps)],
        env={
            "OMP_NUM_THREADS": str(threads),
            "PYTHONPATH": f"{Path(__file__).parents[2] / 'pkg'}:{Path(__file__).parent}",
            "PATH": "/usr/bin:/bin",
        },
        capture_output=True,
        text=True,
        check=True,
    )
    return json.loads(done.stdout.splitlines()[-1])


@pytest.fixture(scope="module")
def elastic() -> tuple[dict, dict, dict]:
    return run(1, 600), run(1, 600), run(2, 600)


def test_threads_are_what_was_asked_for(elastic):
    assert [r["threads"] for r in elastic] == [1, 1, 2]


def test_one_thread_repeats_bit_by_bit(elastic):
    assert elastic[0] == elastic[1]


def test_two_threads_agree_to_round_off(elastic):
    one, _, two = elastic
    assert sorted(one["strength"]) == sorted(two["strength"])
    np.testing.assert_allclose(two["position"], one["position"], rtol=0, atol=1e-14)
    np.testing.assert_allclose(two["force"], one["force"], rtol=1e-8)
