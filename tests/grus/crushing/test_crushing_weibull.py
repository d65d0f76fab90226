"""The shipped card: thirty stamped grains follow a Weibull line."""

from pathlib import Path

import pytest

import grus
from grus.crushing import GroupResult

MODELS = Path(__file__).parents[3] / "models"


@pytest.fixture(scope="module")
def group(tmp_path_factory) -> GroupResult:
    card = grus.Card.from_file(MODELS / "montesinho.toml")
    return grus.crush_group(card, 30, tmp_path_factory.mktemp("thirty"))


def test_weibull_is_not_rejected(group):
    fit = group.weibull()
    assert fit.p_value >= 0.05
    low, high = fit.modulus_ci
    assert 2 < low < fit.modulus < high < 12
    assert fit.sigma0 == pytest.approx(1e6, rel=0.3)


def test_energy_balance_of_every_grain_closes(group):
    assert max(abs(grain.energy_error) for grain in group.grains) < 0.01
