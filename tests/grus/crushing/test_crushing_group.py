"""A group of crushing tests: results, resuming, processes, refusals, files."""

import json
import shutil
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

import grus  # noqa: F401  loads YADE
from grus.campaign import Outcome, Run, Store
from grus.card import Card
from grus.crushing import crush, crush_group, summary, write_report
from grus.crushing.arrays import from_arrays, to_arrays
from grus.crushing.result import CrushingResult
from grus.errors import GrusError

MODELS = Path(__file__).parents[3] / "models"
GRAINS = 4


@pytest.fixture(scope="module")
def card() -> Card:
    return Card.from_file(MODELS / "montesinho.toml").with_overrides({"crush.speed": "0.1 m/s"})


@pytest.fixture(scope="module")
def folder(tmp_path_factory, card) -> Path:
    path = tmp_path_factory.mktemp("group")
    crush_group(card, GRAINS, path, jobs=2)
    return path


@pytest.fixture(scope="module")
def group(card, folder):
    return crush_group(card, GRAINS, folder)


def test_grains_crush_by_splitting(group):
    for grain in group.grains:
        assert grain.broken
        assert grain.tension_breaks > 0 and grain.shear_breaks > 0
        assert grain.after.fragment_count >= 2
        assert grain.before.fragment_count == 1
        assert len(grain.before.bonds) == grain.bonds
        assert len(grain.after.bonds) == grain.bonds - grain.tension_breaks - grain.shear_breaks
    assert sum(g.tension_breaks for g in group.grains) > sum(g.shear_breaks for g in group.grains)


def test_strength_is_force_over_gap_and_thickness(group):
    for grain in group.grains:
        assert grain.area == pytest.approx(grain.gap * 1.0)
        assert grain.strength == pytest.approx(grain.peak_force / grain.gap)
        assert grain.max_strength >= grain.strength


def test_peaks_agree_with_the_record(group):
    for grain in group.grains:
        force = grain.record["force"]
        assert force.max() <= grain.max_force * (1 + 1e-12)
        assert force.max() > 0.95 * grain.max_force
        assert grain.ended == "strain" or force[-1] <= 0.1 * grain.max_force


def test_energy_balance_closes(group):
    assert max(abs(grain.energy_error) for grain in group.grains) < 0.01


def test_parallel_processes_give_what_one_gives(card, group):
    alone = crush(card, grain=2)
    other = group.grains[2]
    assert alone.summary() == other.summary()
    for name in alone.record.channels:
        np.testing.assert_array_equal(alone.record[name], other.record[name])
    np.testing.assert_array_equal(alone.after.position, other.after.position)


def test_goes_on_where_it_was(card, folder, tmp_path, group):
    for source in sorted((folder / "grains").iterdir())[:2]:
        (tmp_path / "grains").mkdir(exist_ok=True)
        (tmp_path / "grains" / source.name).write_bytes(source.read_bytes())
    # What a cut-off run may leave: a half-written file under a name that is not taken for a result.
    (tmp_path / "grains" / "grain-0002.h5").write_bytes(b"half")
    calls = []
    again = crush_group(card, GRAINS, tmp_path, 2, lambda done, of: calls.append((done, of)))
    assert calls == [(2, GRAINS), (3, GRAINS), (4, GRAINS)]
    assert [g.summary() for g in again.grains] == [g.summary() for g in group.grains]


def test_grains_are_runs_of_a_campaign(card, folder, group, tmp_path):
    shutil.copytree(folder / "store", tmp_path / "store")
    calls = []
    again = crush_group(card, GRAINS, tmp_path, 2, lambda done, of: calls.append((done, of)))
    assert calls == [(GRAINS, GRAINS)], "what its store holds is not run again"
    for source in (folder / "grains").iterdir():
        assert (tmp_path / "grains" / source.name).read_bytes() == source.read_bytes()
    outcomes = Store(folder / "store").outcomes()
    found = sorted(outcomes, key=lambda outcome: outcome.grain)
    assert [one.figures["peak.strength"] for one in found] == [g.strength for g in group.grains]
    assert [g.summary() for g in again.grains] == [g.summary() for g in group.grains]


def failure(card: Card, grain: int, refused: bool) -> Outcome:
    run = Run("crush", card, grain)
    return Outcome(
        run.key, "crush", card.to_dict(), grain, failed="ended by SIGKILL", refused=refused
    )


def test_a_grain_that_fails_does_not_stop_the_others(card, folder, group, tmp_path):
    for source in sorted((folder / "grains").iterdir()):
        (tmp_path / "grains").mkdir(exist_ok=True)
        (tmp_path / "grains" / source.name).write_bytes(source.read_bytes())
    (tmp_path / "grains" / "grain-0001.h5").unlink()
    store = Store(tmp_path / "store").make()
    store.save(failure(card, 1, refused=True))
    few = crush_group(card, GRAINS, tmp_path, 1)
    assert few.failed == {1: "ended by SIGKILL"}
    assert [grain.grain for grain in few.grains] == [0, 2, 3]
    assert "failed        1 more" in summary(few) and "grain 1: ended by SIGKILL" in summary(few)
    assert write_report(few, tmp_path)["failed"] == {"1": "ended by SIGKILL"}
    assert "failed" not in write_report(group, tmp_path)
    # The next call tries again unless the card is to blame.
    store.save(failure(card, 1, refused=False))
    whole = crush_group(card, GRAINS, tmp_path, 1)
    assert not whole.failed
    assert [g.summary() for g in whole.grains] == [g.summary() for g in group.grains]


def test_when_every_grain_fails_the_first_reason_is_told(card, tmp_path):
    store = Store(tmp_path / "store").make()
    for grain in range(2):
        store.save(failure(card, grain, refused=True))
    with pytest.raises(GrusError, match="ended by SIGKILL"):
        crush_group(card, 2, tmp_path, 1)


def test_result_survives_its_arrays(group):
    result = group.grains[1]
    outcome = Outcome("ab" * 32, "crush", {}, record=result.record, arrays=to_arrays(result))
    stored = Outcome.from_bytes(outcome.to_bytes())
    loaded = from_arrays(stored.record, stored.arrays)
    assert loaded.summary() == result.summary() and loaded.numbers == result.numbers
    assert loaded.specimen.content_hash() == result.specimen.content_hash()
    for state, other in ((loaded.before, result.before), (loaded.after, result.after)):
        for name, values in vars(other).items():
            np.testing.assert_array_equal(getattr(state, name), values)
            assert getattr(state, name).dtype == values.dtype


def test_result_survives_its_file(group, tmp_path):
    result = group.grains[1]
    result.save(tmp_path / "grain.h5", "key")
    loaded = CrushingResult.load(tmp_path / "grain.h5", "key")
    assert loaded.summary() == result.summary()
    assert loaded.record.units == result.record.units
    assert loaded.specimen.content_hash() == result.specimen.content_hash()
    with pytest.raises(GrusError, match="not a result of this card"):
        CrushingResult.load(tmp_path / "grain.h5", "another key")


def test_folder_of_another_card_is_refused(card, folder):
    other = card.with_overrides({"bond.tensile_strength": "2 MPa"})
    with pytest.raises(GrusError, match="another card or version"):
        crush_group(other, GRAINS, folder)


def test_damaged_owner_is_told(card, tmp_path):
    (tmp_path / "card.json").write_text("{")
    with pytest.raises(GrusError, match="card.json: damaged, or not of Grus"):
        crush_group(card, 1, tmp_path)


def test_too_few_broken_grains_still_give_a_report(card, tmp_path):
    strong = card.with_overrides(
        {"bond.tensile_strength": "1 GPa", "bond.shear_strength": "1 GPa", "crush.max_strain": 2e-4}
    )
    group = crush_group(strong, 3, tmp_path, 2)
    result = write_report(group, tmp_path)
    assert result["broken"] == 0 and "refused" in result["weibull"]
    assert "weibull.png" not in result["files"] and (tmp_path / "fragments.png").exists()
    assert "no fit" in summary(group)


def test_open_mesh_is_refused_before_anything_is_written(tmp_path):
    (tmp_path / "open.stl").write_text(
        "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid s\n"
    )
    model = Card.from_file(MODELS / "montesinho-3d.toml").written
    model["agglomerate"] |= {"outline": "mesh", "mesh": "open.stl"}
    with pytest.raises(GrusError, match='mesh.toml: agglomerate.mesh = "open.stl"'):
        crush_group(Card.from_dict(model, "mesh.toml", tmp_path), 1, tmp_path / "out")
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("grains, jobs, message", [(0, 1, "grains = 0"), (3, -1, "jobs = -1")])
def test_impossible_counts_are_refused(card, tmp_path, grains, jobs, message):
    with pytest.raises(GrusError, match=message):
        crush_group(card, grains, tmp_path, jobs)


def test_report_files(group, tmp_path):
    write_report(group, tmp_path)
    result = json.loads((tmp_path / "result.json").read_text())
    assert result["grains"] == GRAINS
    low, high = result["weibull"]["modulus_ci"]
    assert low < result["weibull"]["modulus"] < high
    assert result["weibull"]["sigma0"] > 0
    assert len(result["tests"]) == GRAINS
    curves = pd.read_csv(tmp_path / "curves.csv")
    assert set(curves["grain"]) == set(range(GRAINS))
    assert {"time [s]", "closing [m]", "force [N]", "released_energy [J]"} <= set(curves.columns)
    for name in ("weibull", "force-displacement", "fragments"):
        assert (tmp_path / f"{name}.png").stat().st_size > 10_000
        assert (tmp_path / f"{name}.svg").stat().st_size > 10_000
    assert len(list((tmp_path / "vtk").glob("*.vtp"))) == 2 * GRAINS


def test_vtk_holds_elements_and_bonds(group, tmp_path):
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

    write_report(group, tmp_path)
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(tmp_path / "vtk" / "grain-0001-after.vtp"))
    reader.Update()
    data, grain = reader.GetOutput(), group.grains[1]
    assert data.GetNumberOfPoints() == grain.specimen.element_count
    assert data.GetNumberOfLines() == len(grain.after.bonds)
    fragment = data.GetPointData().GetArray("fragment")
    assert [int(fragment.GetValue(i)) for i in range(len(grain.after.fragment))] == list(
        grain.after.fragment
    )


def test_summary_is_one_screen(group):
    lines = summary(group).splitlines()
    assert len(lines) < 24 and max(map(len, lines)) <= 100
    assert "Weibull" in summary(group) and "modulus" in summary(group)
