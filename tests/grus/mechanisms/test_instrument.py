"""What the instrument writes down, against formulas."""

import numpy as np
import pytest

from grus.errors import GrusError
from grus.mechanisms import MECHANISMS
from grus.record import Record, Segment

HEIGHT, MODULUS = 0.08, 2e7
STRESS = np.array([5e3, 50e3, 100e3, 400e3, 400e3, 100e3, 5e3])
TIME = np.array([0.0, 60.0, 120.0, 3600.0, 90000.0, 93600.0, 97200.0])


@pytest.fixture
def elastic() -> Record:
    """A specimen that is a spring, from a seating at 5 kPa."""
    channels = {
        "time": TIME,
        "axial_stress": STRESS,
        "axial_strain": (STRESS - STRESS[0]) / MODULUS,
    }
    units = {"time": "s", "axial_stress": "Pa", "axial_strain": "1"}
    seat = Segment("seat", 0, 0, 0, 0.0, 0.0, 5e3, 5e3)
    return Record(channels, units, {"height": HEIGHT}, (seat,))


def distorted(name: str, record: Record, **values: float) -> Record:
    return MECHANISMS[name].distort(record, values)


def test_springs_in_series(elastic):
    """One over the stiffness of the whole is the sum of that of its parts: 1/M' = 1/M + C/H."""
    compliance = 5e-11
    found = distorted("platen_compliance", elastic, compliance=compliance, closure=0.0)
    modulus = 1 / (1 / MODULUS + compliance / HEIGHT)
    np.testing.assert_allclose(
        found["axial_strain"], (STRESS - STRESS[0]) / modulus, rtol=1e-12, atol=1e-18
    )
    assert found["axial_stress"] is elastic["axial_stress"]


def test_closing_gap(elastic):
    values = {"compliance": 0.0, "closure": 1e-4, "toe_stress": 2e4}
    extra = (
        distorted("platen_compliance", elastic, **values)["axial_strain"] - elastic["axial_strain"]
    )
    closed = 1e-4 * (1 - np.exp(-STRESS / 2e4)) / HEIGHT
    np.testing.assert_allclose(extra, closed - closed[0], rtol=1e-9, atol=1e-15)
    # elastic: the way back is the way there
    assert extra[-1] == 0 and extra[2] == extra[5]


def test_compliance_needs_a_height(elastic):
    bare = Record(elastic.channels, elastic.units)
    with pytest.raises(GrusError, match="no height"):
        distorted("platen_compliance", bare)


def test_drift_and_offset(elastic):
    values = {"strain_rate": 1e-9, "strain_offset": 2e-4, "stress_rate": -0.01}
    found = distorted("instrument_drift", elastic, **values)
    expected = elastic["axial_strain"] + 2e-4 + 1e-9 * TIME
    np.testing.assert_allclose(found["axial_strain"], expected, rtol=1e-12)
    np.testing.assert_allclose(found["axial_stress"], STRESS - 0.01 * TIME, rtol=1e-12)
    assert found.segments == elastic.segments and found.meta == elastic.meta


def test_drift_needs_a_time(elastic):
    timeless = {n: v for n, v in elastic.channels.items() if n != "time"}
    record = Record(timeless, {n: elastic.units[n] for n in timeless})
    with pytest.raises(GrusError, match="channel time is missing"):
        distorted("instrument_drift", record)
    shifted = distorted("instrument_drift", record, strain_rate=0.0, strain_offset=1e-3)
    np.testing.assert_allclose(shifted["axial_strain"], record["axial_strain"] + 1e-3)


@pytest.mark.parametrize("name", set(MECHANISMS) - {"platen_compliance", "instrument_drift"})
def test_others_leave_the_record_alone(elastic, name):
    assert distorted(name, elastic) is elastic
