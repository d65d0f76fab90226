import numpy as np
import pytest


class Stream:
    """Random numbers of a test, from `random` alone."""

    def __init__(self, *ids):
        sequence = np.random.SeedSequence(entropy=2015, spawn_key=ids)
        self.generator = np.random.Generator(np.random.PCG64(sequence))

    def normal(self, count):
        """Standard normal numbers (count,), by Box and Muller."""
        radius = np.sqrt(-2 * np.log1p(-self.generator.random(count)))
        return radius * np.cos(2 * np.pi * self.generator.random(count))

    def events(self, expected):
        """Cumulated number of events (n,) of which `expected` (n,) is the cumulated mean."""
        total = float(expected[-1])
        gaps = -np.log1p(-self.generator.random(int(3 * total) + 30))
        return np.searchsorted(np.cumsum(gaps), expected).astype(float)


@pytest.fixture(name="stream")
def stream_fixture():
    return Stream


@pytest.fixture
def stages():
    """Ten stages to 1 MPa [Pa]."""
    return np.linspace(100e3, 1000e3, 10)


@pytest.fixture
def dense():
    """A record from 5 kPa to 1 MPa [Pa]."""
    return np.geomspace(5e3, 1e6, 1500)
