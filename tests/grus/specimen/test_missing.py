import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from grus.errors import GrusError
from grus.specimen import Circle, agglomerate
from grus.specimen.missing import remaining
from grus.specimen.stream import Purpose, stream
from grus.specimen.touching import connected_parts, touching_pairs


@given(st.integers(1, 300), st.floats(0, 1, exclude_max=True), st.integers(0, 99))
def test_the_stated_share_is_taken_out(count, fraction, seed):
    left = remaining(count, fraction, stream(seed, 0, Purpose.MISSING))
    assert (np.diff(left) > 0).all() and 0 <= left[0] and left[-1] < count
    assert len(left) == max(1, count - int(fraction * count + 0.5))


def test_each_element_is_as_likely_to_be_missing():
    left = [remaining(20, 0.25, stream(seed, 0, Purpose.MISSING)) for seed in range(800)]
    counts = np.bincount(np.concatenate(left), minlength=20)
    assert abs(counts - 600).max() < 4 * np.sqrt(800 * 0.75 * 0.25)


@pytest.mark.parametrize("missing", [0.1, 0.3, 0.6])
def test_grain_stays_connected(missing):
    full = agglomerate(Circle(20e-3), 0.6e-3, seed=4)
    holed = agglomerate(Circle(20e-3), 0.6e-3, missing=missing, seed=4)
    assert holed.element_count <= round((1 - missing) * full.element_count)
    pairs = touching_pairs(holed.position, holed.radius)
    assert not connected_parts(holed.element_count, pairs).any()
    if missing == 0.1:
        assert holed.element_count >= 0.98 * 0.9 * full.element_count
    # What is left lies where it was.
    gap = np.linalg.norm(holed.position[:, None] - full.position[None], axis=2).min(axis=1)
    assert gap.max() < 1e-15


@pytest.mark.parametrize("fraction", [-0.1, 1.0, float("nan")])
def test_invalid_fraction(fraction):
    with pytest.raises(GrusError, match=r"missing = .*: must be a fraction in \[0, 1\)"):
        agglomerate(Circle(20e-3), 0.6e-3, missing=fraction, seed=0)
