from pathlib import Path

import pytest
from stand_in import GRAINS, StandIn

import grus  # noqa: F401  loads YADE
from grus.calibrate import conduct
from grus.card import Card

PLANE = Path(__file__).parents[2] / "cards" / "plane.toml"
STRENGTHS = f"""
grains = {GRAINS}
[parameters]
bond.tensile_strength = {{ low = "0.5 MPa", high = "4 MPa", logarithmic = true, tied = ["bond.shear_strength"]}}
bond.scatter.modulus = {{ low = 1, high = 8 }}

[targets]
characteristic_strength = {{ value = "1.7 MPa", tolerance = "50 kPa" }}
weibull_modulus = {{ value = 4, tolerance = 0.3 }}
"""


@pytest.fixture(scope="session")
def card() -> Card:
    return Card.from_file(PLANE)


@pytest.fixture
def stand_in(monkeypatch):
    """Puts a stand-in into the place of the campaign layer."""

    def put(**options) -> StandIn:
        made = StandIn(**options)
        monkeypatch.setattr(conduct, "campaign", made.campaign)
        monkeypatch.setattr(conduct, "workers", made.workers)
        return made

    return put


@pytest.fixture
def write(tmp_path):
    """Writes a file of targets."""

    def to(text: str) -> Path:
        path = tmp_path / "targets.toml"
        path.write_text(text)
        return path

    return to
