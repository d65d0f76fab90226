"""Platen control, and grains in space."""

from pathlib import Path

import numpy as np
import pytest

import grus  # noqa: F401  loads YADE
from grus.card import Card
from grus.crushing import CrushingTest, crush
from yade import O

MODELS = Path(__file__).parents[3] / "models"


def card(**changes: object) -> Card:
    keys = {name.replace("__", "."): value for name, value in changes.items()}
    return Card.from_file(MODELS / "montesinho.toml").with_overrides(
        {"crush.speed": "0.1 m/s", "agglomerate.leftover": "single"} | keys
    )


def test_platens_close_at_the_speed_asked_for():
    result = crush(card())
    record = result.record
    np.testing.assert_allclose(np.diff(record["closing"]), 0.1 * np.diff(record["time"]), rtol=1e-9)


def test_platens_move_in_opposite_directions_at_the_same_speed():
    test = CrushingTest(card())
    bottom, top = (O.bodies[i].state for i in (test.platens.bottom, test.platens.top))
    middle = bottom.pos[1] + top.pos[1]
    O.run(500, True)
    assert bottom.pos[1] + top.pos[1] == pytest.approx(middle, abs=1e-12)
    assert bottom.vel[1] == -top.vel[1] == 0.05


def test_force_control_follows_the_ramp_below_the_speed_cap():
    rate = 3e6
    test = CrushingTest(
        card(crush__control="force", crush__force_rate=f"{rate} N/s", crush__speed="0.1 m/s")
    )
    result = test.run()
    record = result.record
    closing_speed = np.diff(record["closing"]) / np.diff(record["time"])
    assert closing_speed.max() <= 0.1 * (1 + 1e-9)
    ramp = record["force"] < 0.6 * result.peak_force
    ramp &= np.arange(len(record)) < record["force"].argmax()
    error = record["force"][ramp] - rate * record["time"][ramp]
    assert np.abs(error).max() < 0.05 * result.peak_force
    assert result.broken


def test_control_hardly_matters_for_the_strength():
    by_speed = crush(card(crush__speed="0.02 m/s"))
    by_force = crush(
        card(crush__control="force", crush__force_rate="8e6 N/s", crush__speed="0.1 m/s")
    )
    assert by_force.strength == pytest.approx(by_speed.strength, rel=0.05)


def test_strain_limit_ends_a_test_without_breakage():
    result = crush(
        card(bond__tensile_strength="1 GPa", bond__shear_strength="1 GPa", crush__max_strain=5e-4)
    )
    assert (result.ended, result.broken, result.peak_force) == ("strain", False, 0)
    assert result.tension_breaks == result.shear_breaks == 0
    assert result.strength == result.max_strength > 0


def test_an_unbroken_grain_gives_its_work_back_as_elastic_energy():
    result = crush(
        card(bond__tensile_strength="1 GPa", bond__shear_strength="1 GPa", crush__max_strain=5e-4)
    )
    record = result.record
    assert record["elastic_energy"][-1] > 0.9 * record["work"][-1]
    assert record["released_energy"][-1] == 0


def test_grain_in_space_crushes():
    model = Card.from_file(MODELS / "montesinho-3d.toml").with_overrides({"crush.speed": "0.2 m/s"})
    result = crush(model)
    assert result.broken and result.after.fragment_count > 1
    assert result.area == pytest.approx(result.gap**2)
    assert abs(result.energy_error) < 0.01
