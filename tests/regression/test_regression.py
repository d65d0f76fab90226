"""The small cards give the stored figures. After a change on purpose: scripts/refresh-regression."""

import json
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from compare import STORED, THREADS, Difference, compute, differences  # noqa: E402


@pytest.fixture(scope="module")
def specimens(tmp_path_factory) -> Path:
    return tmp_path_factory.mktemp("specimens")


@pytest.mark.parametrize("threads", THREADS)
def test_figures_are_as_stored(threads, specimens):
    stored = json.loads(STORED.read_text())[threads]
    changed = differences(stored, compute(threads, specimens), tolerant=threads > "1")
    assert [str(one) for one in changed] == []


def test_a_change_is_seen():
    stored = {"run": {"grain 0": {"bonds": 100, "strength": 1.0, "work": 2.0}}}
    assert not list(differences(stored, stored, tolerant=False))
    found = {"run": {"grain 0": {"bonds": 101, "strength": 1.0 + 1e-5, "steps": 3}}}
    assert [str(one) for one in differences(stored, found, tolerant=False)] == [
        "run, grain 0, bonds: 100 -> 101 (+1 %)",
        "run, grain 0, strength: 1.0 -> 1.00001 (+0.001 %)",
        "run, grain 0, work: 2.0 -> None",
        "run, grain 0, steps: None -> 3",
    ]
    assert list(differences(stored, found, tolerant=True)) == [
        Difference("run, grain 0, work", 2.0, None),
        Difference("run, grain 0, steps", None, 3),
    ]
