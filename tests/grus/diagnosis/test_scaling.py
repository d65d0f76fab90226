"""Parameters of mechanisms between laboratory and small model."""

import pytest

from grus.diagnosis.scaling import Scaling

SCALING = Scaling(stiffness=2.0, stress=10.0, height=0.5)


@pytest.mark.parametrize(
    "name, unit, factor",
    [
        ("platen_compliance", "m/Pa", 0.5 * 2.0),
        ("platen_compliance", "m", 0.5 * 2.0),
        ("platen_compliance", "Pa", 1.0),
        ("instrument_drift", "Pa/s", 1.0),
        ("instrument_drift", "1/s", 2.0),
        ("hertzian_contact", "Pa", 10.0),
        ("bond_ageing", "s", 1.0),
        ("wall_friction", "1", 1.0),
    ],
)
def test_factor_of_the_runs(name, unit, factor):
    assert SCALING.simulated(name, unit) == pytest.approx(factor)


def test_a_seat_closes_by_the_same_strain_in_specimens_of_any_height():
    """A gap of the laboratory's platens over its height is the model's over its own."""
    laboratory, model = 0.08, 0.02
    gap = 2e-5
    simulated = gap * Scaling(height=model / laboratory).simulated("platen_compliance", "m")
    assert simulated / model == pytest.approx(gap / laboratory)
