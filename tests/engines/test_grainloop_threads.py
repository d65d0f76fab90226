"""GrainLoop with two threads: the same bits each time, and the same as with one thread to round-off."""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

SCRIPT = """
import json
from scenes import card, engine
from test_grainloop import crushing
from yade import O
test = crushing(card(crush__speed="0.2 m/s"), loop=True, substeps=50)
O.run(600, True)
print(json.dumps({
    "threads": O.numThreads,
    "position": [list(b.state.pos) for b in O.bodies],
    "force": list(test.platens.recordForce),
    "sliding": list(test.platens.recordSliding),
}))
"""


def run(threads: int) -> dict:
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT],
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
def runs() -> tuple[dict, dict, dict]:
    return run(1), run(2), run(2)


def test_two_threads_repeat_bit_by_bit(runs):
    one, two, again = runs
    assert [r["threads"] for r in runs] == [1, 2, 2]
    assert two == again


def test_two_threads_agree_with_one(runs):
    one, two, _ = runs
    np.testing.assert_allclose(two["position"], one["position"], rtol=0, atol=1e-13)
    np.testing.assert_allclose(two["force"], one["force"], rtol=1e-7)
    np.testing.assert_allclose(two["sliding"], one["sliding"], rtol=1e-6, atol=1e-12)
