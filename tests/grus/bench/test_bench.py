"""The benchmark's book-keeping; nothing here looks at how long anything takes."""

import json

import pytest

from grus.bench import FULL, QUICK, Case, Timing, measure, summary, write
from grus.bench.cases import LOOPS


def timing(loop: str, step: float, case: Case = Case(2, 1000, True)) -> Timing:
    return Timing(case, loop, elements=900, bonds=2000, step=step, repeats=7)


def test_ratio_is_the_geometric_mean_over_the_largest_stamped_cases():
    small, plane, space = Case(2, 100, True), Case(2, 1000, True), Case(3, 1000, True)
    spheres, two = Case(2, 1000, False), Case(2, 1000, True, threads=2)
    timings = []
    for case, slow in ((small, 100), (plane, 4), (space, 9), (spheres, 100), (two, 100)):
        timings += [timing("cohfrict_moments", slow, case), timing("grainloop", 1, case)]
    assert summary(timings)["ratio"] == {"cohfrict_moments_over_grainloop": pytest.approx(6)}


def test_seconds_per_bond():
    assert timing("law2", 1e-3).per_bond == pytest.approx(5e-7)


def test_file_holds_every_timing(tmp_path):
    path = write(tmp_path / "new", [timing("jcfpm", 3.0), timing("grainloop", 2.0)])
    found = json.loads(path.read_text())
    assert path.name == "bench.json"
    assert found["ratio"] == {"jcfpm_over_grainloop": pytest.approx(1.5)}
    assert [t["loop"] for t in found["timings"]] == ["jcfpm", "grainloop"]
    assert found["timings"][0]["case"]["dimension"] == 2


def test_cases_cover_plane_and_space_and_both_numbers_of_threads():
    assert {(c.dimension, c.threads) for c in FULL} == {(2, 1), (2, 2), (3, 1), (3, 2)}
    assert {c.dimension for c in QUICK} == {2, 3}
    assert len({c.name for c in FULL}) == len(FULL)


def test_every_loop_is_measured_on_the_same_bonds():
    found = measure([Case(2, 150, True)])
    assert [t.loop for t in found] == list(LOOPS)
    assert len({(t.elements, t.bonds) for t in found}) == 1
    assert all(t.step > 0 for t in found)
