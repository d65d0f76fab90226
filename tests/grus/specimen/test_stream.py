import numpy as np
import pytest

from grus.errors import GrusError
from grus.specimen.stream import Purpose, stream


def test_streams_are_the_same_everywhere():
    expected = np.random.Generator(np.random.PCG64(np.random.SeedSequence(5, spawn_key=(7, 1))))
    assert (stream(5, 7, Purpose.STAMP).random(4) == expected.random(4)).all()


def test_seed_grain_and_purpose_each_give_another_stream():
    first = {
        stream(seed, grain, purpose).random()
        for seed in range(5)
        for grain in range(5)
        for purpose in Purpose
    }
    assert len(first) == 5 * 5 * len(Purpose)


@pytest.mark.parametrize(
    "seed, grain, message",
    [(-1, 0, "seed = -1: must be >= 0"), (0, -2, "grain = -2: must be >= 0")],
)
def test_invalid_ids(seed, grain, message):
    with pytest.raises(GrusError, match=message):
        stream(seed, grain, Purpose.LATTICE)
