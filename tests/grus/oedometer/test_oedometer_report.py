"""What a test leaves in its folder."""

import json
import re

import numpy as np
import pandas as pd
import pytest
from matplotlib.figure import Figure

from grus.errors import GrusError
from grus.oedometer import summary, write_report
from grus.oedometer.evenly import evenly
from grus.plotting.energy import energy_plot
from grus.plotting.lateral import lateral_plot
from grus.recording import read

FIGURES = (
    "compression",
    "breakage",
    "grading",
    "energy",
    "K0",
    "force-chains",
    "crushed",
)


@pytest.fixture(scope="module")
def report(plane_result, tmp_path_factory):
    """Folder and content of result.json."""
    folder = tmp_path_factory.mktemp("report")
    write_report(plane_result, folder)
    return folder, json.loads((folder / "result.json").read_text())


@pytest.fixture(scope="module")
def curve(report):
    return pd.read_csv(report[0] / "curve.csv")


def test_all_files_are_there(report, plane_result):
    folder, found = report
    names = {path.name for path in folder.iterdir()}
    assert {f"{name}.{kind}" for name in FIGURES for kind in ("png", "svg")} <= names
    assert {"result.json", "curve.csv", "stages.csv", "grading.csv", "vtk"} <= names
    assert {path.name for path in (folder / "vtk").iterdir()} == {
        f"stage-{end.number:03d}.vtp" for end in plane_result.stages
    }
    assert all((folder / name).exists() for name in found["files"])


def test_report_in_space(space_result, tmp_path):
    found = write_report(space_result, tmp_path)
    assert all((tmp_path / name).exists() for name in found["files"])


def test_result_is_written_last(plane_result, tmp_path, monkeypatch):
    def fail(*_):
        raise OSError("disk full")

    monkeypatch.setattr("grus.oedometer.report.write_vtk", fail)
    with pytest.raises(OSError):
        write_report(plane_result, tmp_path)
    assert (tmp_path / "curve.csv").exists() and not (tmp_path / "result.json").exists()


def test_numbers_are_those_of_the_result(report, plane_result):
    _, found = report
    last = plane_result.stages[-1]
    assert found["void_ratio"]["initial"] == plane_result.seated.void_ratio
    assert found["void_ratio"]["final"] == last.void_ratio
    assert found["bonds"] == {
        "initial": plane_result.bonds,
        "broken": last.tension_breaks + last.shear_breaks,
        "broken_in_tension": last.tension_breaks,
        "broken_in_shear": last.shear_breaks,
        "broken_share": last.breaks / plane_result.bonds,
    }
    assert abs(found["energy"]["error"]) < 0.01
    assert found["mass"]["error"] < 1e-12
    assert found["K0"]["final"] == last.K0
    assert found["steps"] == last.steps
    assert found["card_hash"] == plane_result.card.content_hash()
    assert {"grus", "yade", "python"} == set(found["versions"])
    assert [stage["target"] for stage in found["stages"]] == [5e3, 100e3, 300e3, 50e3]
    assert found["stages"][0]["breakage"]["hardin"] == 0
    assert found["stages"][-1]["breakage"]["marsal"] >= 0


def test_stress_without_a_reason_or_a_reason_without_a_stress(report):
    for name in ("yield", "onset"):
        one = report[1][name]
        assert ("why" in one) == (one["stress"] is None) == (one["interval"] is None)


def test_every_number_has_its_unit(curve, report):
    tables = [pd.read_csv(report[0] / f"{name}.csv") for name in ("stages", "grading")]
    for table in (curve, *tables):
        for header in table.columns:
            assert re.fullmatch(r"kind|[\w ]+ \[(1|%|s|m/s|kPa|mm|J|1/m)\]", header), header


def test_curve_is_the_record(curve, plane_result):
    assert len(curve) == len(plane_result.record)
    np.testing.assert_allclose(1e3 * curve["axial_stress [kPa]"], plane_result.stress, rtol=1e-8)
    np.testing.assert_allclose(curve["void_ratio [1]"], plane_result.void_ratio, rtol=1e-8)
    seated = plane_result.seated
    height = 1e-3 * curve["height [mm]"]
    np.testing.assert_allclose(
        curve["axial_strain [1]"], 1 - height / seated.height, rtol=0, atol=1e-7
    )
    end = curve[curve["stage [1]"] == 0].iloc[-1]
    assert end["axial_strain [1]"] == 0 and end["void_ratio_normalised [1]"] == 1
    assert curve["bonds_broken [1]"].iloc[-1] == plane_result.stages[-1].breaks


def test_curve_is_read_as_a_recording(report, plane_result):
    recording = read(report[0] / "curve.csv")
    np.testing.assert_allclose(recording["axial_stress"], plane_result.stress, rtol=1e-8)
    sides = plane_result.record["side_stress"]
    np.testing.assert_allclose(recording["lateral_stress"], sides, rtol=1e-8)
    strain = 1 - plane_result.record["height"] / plane_result.seated.height
    np.testing.assert_allclose(recording["axial_strain"], strain, rtol=1e-8, atol=1e-12)


def test_gradings_lose_no_mass(report, plane_result):
    table = pd.read_csv(report[0] / "grading.csv")
    assert len(table.columns) == 1 + len(plane_result.stages)
    passing = table.iloc[:, 1:]
    assert (passing.iloc[-1] == 100).all() and (passing.diff().iloc[1:] >= 0).all(axis=None)
    # Breakage moves mass to the fine side.
    assert (passing.iloc[:, -1] >= passing.iloc[:, 0] - 1e-9).all()


def test_summary_fits_a_screen(plane_result):
    lines = summary(plane_result).splitlines()
    assert len(lines) <= 24 and max(map(len, lines)) <= 100
    text = "\n".join(lines)
    for part in ("void ratio", "load to 300 kPa", "yield", "Hardin", "energy", "mass"):
        assert part in text


def test_some_of_many():
    assert evenly(3, 8) == [0, 1, 2]
    assert evenly(100, 5) == [0, 25, 50, 74, 99]


def test_plots_refuse_what_they_cannot_draw():
    one, two = np.ones(1), np.ones(2)
    with pytest.raises(GrusError, match="of one length"):
        energy_plot(one, ["load"], two, {"elastic": two}, two)
    with pytest.raises(GrusError, match="parts: 0"):
        energy_plot(two, ["load"], two, {}, two)
    with pytest.raises(GrusError, match="of one length"):
        lateral_plot(one, two, two > 0, np.array([0]))
    with pytest.raises(GrusError, match="no stress above zero"):
        lateral_plot(0 * two, two, two > 0, np.array([0]))


def test_plots_of_a_single_stage():
    rising = np.linspace(1e3, 1e5, 9)
    ends = np.array([8])
    assert isinstance(lateral_plot(rising, 0.5 + 0 * rising, rising < 0, ends), Figure)
    progress = np.linspace(0, 1, 9)
    figure = energy_plot(progress, ["load"], rising, {"elastic": rising}, 0 * rising)
    assert len(figure.axes) == 2
