import os

import h5py
import numpy as np
import pytest

from grus.errors import GrusError
from grus.specimen import Circle, Sphere, Specimen, Stamp, agglomerate


def three_in_a_row(**change) -> Specimen:
    fields = dict(
        dimension=2,
        position=[[0.0, 0, 0], [2.0, 0, 0], [4.0, 0, 0]],
        radius=[1.0, 1.0, 1.0],
        clump=[0, 0, 1],
        grain=[0, 0, 0],
        grain_diameter=[6.0],
        meta={"seed": 1, "pair": (1, 2)},
    )
    return Specimen(**(fields | change))


def test_bonds_join_touching_elements_of_different_clumps():
    assert three_in_a_row().bonds().tolist() == [[1, 2]]
    assert three_in_a_row(clump=[0, 1, 2]).bonds().tolist() == [[0, 1], [1, 2]]
    assert three_in_a_row(clump=[0, 0, 0]).bonds().shape == (0, 2)


def test_bonds_stay_within_a_grain():
    two = three_in_a_row(clump=[0, 1, 2], grain=[0, 0, 1], grain_diameter=[4.0, 2.0])
    assert two.bonds().tolist() == [[0, 1]]


def test_bonds_bridge_gaps_up_to_the_tolerance():
    gaping = three_in_a_row(position=[[0, 0, 0], [2.001, 0, 0], [4.0, 0, 0]], clump=[0, 1, 2])
    assert gaping.bonds().tolist() == [[1, 2]]
    assert gaping.bonds(tolerance=2e-3).tolist() == [[0, 1], [1, 2]]


def test_arrays_are_read_only_copies():
    radius = np.ones(3)
    specimen = three_in_a_row(radius=radius)
    radius[0] = 5.0
    assert specimen.radius[0] == 1.0
    with pytest.raises(ValueError, match="read-only"):
        specimen.position[0, 0] = 1.0


def test_counts():
    specimen = three_in_a_row()
    counts = specimen.element_count, specimen.clump_count, specimen.grain_count
    assert counts == (3, 2, 1)


def test_hash_depends_on_all_content_and_on_nothing_else():
    changes = [
        {"dimension": 3},
        {"thickness": 2.0},
        {"position": [[0.0, 1e-15, 0], [2.0, 0, 0], [4.0, 0, 0]]},
        {"radius": [1.0, 1.0, 0.9]},
        {"clump": [0, 1, 1]},
        {"grain": [0, 0, 1], "grain_diameter": [6.0, 6.0]},
        {"grain_diameter": [5.0]},
        {"meta": {"seed": 2}},
    ]
    hashes = {three_in_a_row(**change).content_hash() for change in [{}] + changes}
    assert len(hashes) == 1 + len(changes)
    reordered = three_in_a_row(meta={"pair": [1, 2], "seed": 1})
    assert reordered.content_hash() == three_in_a_row().content_hash()


def test_hash_is_the_stored_one():
    assert three_in_a_row().content_hash() == (
        "23ae96c8dfb044bac911abb19f75b3117044433523386d0698867c1dbfb2045c"
    )


@pytest.mark.parametrize("outline", [Circle(12.6e-3), Sphere(6e-3)])
def test_round_trip_is_exact(tmp_path, outline):
    stamp = Stamp(mean=1e-3, deviation=0.2e-3)
    saved = agglomerate(outline, 0.6e-3, stamp=stamp, seed=1, thickness=0.3)
    saved.save(tmp_path / "grain.h5")
    loaded = Specimen.load(tmp_path / "grain.h5")
    for name in ("position", "radius", "clump", "grain", "grain_diameter"):
        before, after = getattr(saved, name), getattr(loaded, name)
        assert before.dtype == after.dtype and before.tobytes() == after.tobytes()
    assert (loaded.dimension, loaded.thickness) == (saved.dimension, saved.thickness)
    assert loaded.meta == saved.meta
    assert loaded.content_hash() == saved.content_hash()


def test_meta_may_be_long(tmp_path):
    saved = three_in_a_row(meta={"parts": ["x" * 100] * 2000})
    saved.save(tmp_path / "long.h5")
    assert Specimen.load(tmp_path / "long.h5").meta == saved.meta


def test_a_save_that_fails_leaves_the_old_file(tmp_path, monkeypatch):
    path = tmp_path / "grain.h5"
    three_in_a_row().save(path)

    def refuse(*_):
        raise OSError("disk full")

    monkeypatch.setattr(os, "replace", refuse)
    with pytest.raises(OSError, match="disk full"):
        three_in_a_row(clump=[0, 1, 2]).save(path)
    assert Specimen.load(path).clump_count == 2
    assert [file.name for file in tmp_path.iterdir()] == ["grain.h5"]


def test_save_replaces_an_older_file(tmp_path):
    three_in_a_row().save(tmp_path / "grain.h5")
    three_in_a_row(clump=[0, 1, 2]).save(tmp_path / "grain.h5")
    assert Specimen.load(tmp_path / "grain.h5").clump_count == 3


def test_load_refuses_what_was_changed(tmp_path):
    path = tmp_path / "grain.h5"
    three_in_a_row().save(path)
    with h5py.File(path, "r+") as file:
        file["radius"][1] = 0.5
    with pytest.raises(GrusError, match="must be the content whose hash is stored with it"):
        Specimen.load(path)


def test_load_refuses_other_files(tmp_path):
    with pytest.raises(FileNotFoundError, match="does not exist"):
        Specimen.load(tmp_path / "none.h5")
    (tmp_path / "text.h5").write_text("no")
    with pytest.raises(GrusError, match="must be an HDF5 file"):
        Specimen.load(tmp_path / "text.h5")
    h5py.File(tmp_path / "other.h5", "w").close()
    with pytest.raises(GrusError, match="must be of the format 'grus specimen 1'"):
        Specimen.load(tmp_path / "other.h5")


@pytest.mark.parametrize(
    "change, message",
    [
        ({"dimension": 1}, "dimension = 1: must be 2 or 3"),
        ({"thickness": -1.0}, "thickness = -1.0: must be finite and > 0 m"),
        ({"position": np.zeros((3, 2))}, r"shape of position = \(3, 2\): must be \(3, 3\)"),
        ({"position": np.full((3, 3), np.inf)}, "position = not finite: must be finite"),
        ({"position": np.eye(3)}, "z of a plane specimen = not 0: must be 0"),
        ({"radius": [1.0, 0.0, 1.0]}, r"radius = \[0.\]: must be finite and > 0 m"),
        ({"radius": []}, "number of elements = 0: must be at least 1"),
        ({"clump": [0, 2, 2]}, r"clump = without \[1\]: must be numbered 0, 1, ... without gaps"),
        ({"clump": [-1, 0, 1]}, "lowest clump = -1: must be >= 0"),
        ({"clump": [0, 1]}, r"shape of clump = \(2,\): must be \(3,\)"),
        ({"grain": [0, 1, 1], "grain_diameter": [1, 1]}, r"grain = mixed in clump \[0\]"),
        ({"grain_diameter": [1.0, 1.0]}, "length of grain_diameter = 2: must be 1"),
        ({"grain_diameter": [-1.0]}, r"grain_diameter = \[-1.\]: must be finite and > 0 m"),
        ({"clump": [0, 0.5, 1]}, "clump = not whole: must be whole numbers"),
        ({"meta": {"x": float("nan")}}, "meta = .*: must be what JSON can hold"),
        ({"meta": {"x": np.zeros(1)}}, "meta = .*: must be what JSON can hold"),
    ],
)
def test_invalid_specimen(change, message):
    with pytest.raises(GrusError, match=message) as refusal:
        three_in_a_row(**change)
    assert "\n" not in str(refusal.value)
