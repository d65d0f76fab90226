"""What is measured and what is made of it; nothing here looks at how long anything takes."""

import io
import json

import pytest
from blocks import SPHERES, timing
from rich.console import Console

from grus.bench import FULL, QUICK, Case, cases, measure, print_table, summary, write
from grus.bench.cases import LOOPS, OTHER_CODES


def test_ratio_is_the_geometric_mean_over_the_largest_stamped_cases():
    small, plane, space = Case(2, 100, True), Case(2, 1000, True), Case(3, 1000, True)
    spheres, two = Case(2, 1000, False), Case(2, 1000, True, threads=2)
    timings = []
    for case, slow in ((small, 100), (plane, 4), (space, 9), (spheres, 100), (two, 100)):
        timings += [timing("cohfrict_moments", slow, case), timing("grainloop", 1, case)]
    assert summary(timings)["ratio"] == {"cohfrict_moments_over_grainloop": pytest.approx(6)}


def test_ratio_of_a_code_without_clumps_is_that_of_spheres():
    stamped, spheres = Case(2, 1000, True), Case(2, 1000, False)
    timings = [timing("grainloop", 1, stamped), timing("jcfpm", 5, stamped)]
    timings += [timing("grainloop", 2, spheres), timing("lammps", 6, spheres)]
    ratio = summary(timings)["ratio"]
    assert ratio["jcfpm_over_grainloop"] == pytest.approx(5)
    assert ratio["lammps_over_grainloop"] == pytest.approx(3)


def test_seconds_per_bond_and_steps_of_elements_per_second():
    assert timing("law2", 1e-3).per_bond == pytest.approx(5e-7)
    assert timing("law2", 1e-3).rate == pytest.approx(9e5)


def test_file_holds_every_timing(tmp_path):
    path = write(tmp_path / "new", [timing("jcfpm", 3.0), timing("grainloop", 2.0)])
    found = json.loads(path.read_text())
    assert path.name == "bench.json"
    assert found["ratio"] == {"jcfpm_over_grainloop": pytest.approx(1.5)}
    assert [t["loop"] for t in found["timings"]] == ["jcfpm", "grainloop"]
    assert found["timings"][0]["case"]["dimension"] == 2
    assert found["timings"][0]["seconds_per_bond"] == pytest.approx(1.5e-3)
    assert found["timings"][0]["element_steps_per_second"] == pytest.approx(300)


def test_cases_cover_plane_and_space_and_both_numbers_of_threads():
    assert {(c.dimension, c.threads) for c in FULL} == {(2, 1), (2, 2), (3, 1), (3, 2)}
    assert {c.dimension for c in QUICK} == {2, 3}
    assert len({c.name for c in FULL}) == len(FULL)


def test_cases_are_all_combinations_of_what_is_chosen():
    found = cases(dimensions=[3], elements=[500, 700, 500], kinds=["clumps"], threads=[1])
    assert found == [Case(3, 500, True), Case(3, 700, True)]


def test_other_codes_take_part_where_elements_are_free_and_threads_one():
    assert set(Case(2, 1000, False).loops) == set(LOOPS) | set(OTHER_CODES)
    assert set(Case(2, 1000, True).loops) == set(LOOPS)
    assert set(Case(2, 1000, False, threads=2).loops) == set(LOOPS)


def test_table_names_what_is_not_installed():
    case = SPHERES[0]
    timings = [timing(loop, 1e-3, case) for loop in [*LOOPS, "esys"]]
    shown = io.StringIO()
    print_table(timings, Console(file=shown, width=200))
    rows = shown.getvalue().splitlines()
    absent = next(i for i, row in enumerate(rows) if OTHER_CODES["lammps"] in row)
    assert "(not installed)" in rows[absent + 1]
    assert "0.9" in next(row for row in rows if OTHER_CODES["esys"] in row)
    assert "900 elements, 2000 bonds" in rows[0]
    assert max(map(len, rows)) <= 80
    assert summary(timings)["not_installed"] == {case.name: ["lammps"]}


def test_every_loop_is_measured_on_the_same_bonds():
    rounds = []
    found = measure(Case(2, 150, True), lambda: rounds.append(None))
    assert [t.loop for t in found] == list(LOOPS)
    assert len({(t.elements, t.bonds) for t in found}) == 1
    assert all(t.step > 0 for t in found)
    assert len(rounds) == 8
