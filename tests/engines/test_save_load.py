"""A test that is saved in the middle and loaded again goes on as if nothing had been."""

import pytest
from scenes import running, state
from yade import O

BEFORE, AFTER = 1500, 1500  # bonds break in both halves


@pytest.fixture(scope="module")
def undisturbed() -> dict:
    running(BEFORE)
    O.run(AFTER, True)
    return state()


@pytest.mark.parametrize("suffix", [".yade.gz", ".xml", ".xml.bz2"])
def test_goes_on_bit_by_bit(tmp_path, suffix, undisturbed):
    running(BEFORE)
    saved = state()
    path = str(tmp_path / f"scene{suffix}")
    O.save(path)
    O.reset()
    O.load(path)
    assert state() == saved
    O.run(AFTER, True)
    assert state() == undisturbed


def test_both_halves_see_breakage(undisturbed):
    counts = undisturbed["record"]
    assert any(max(series, default=0) > 5 for series in counts)
