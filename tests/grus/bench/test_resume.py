"""A measurement that goes on in the folder of an earlier one, and the command line around it."""

import json
from importlib import import_module

import pytest
from blocks import timing

from grus.bench import Case, bench, read, write
from grus.bench.cases import LOOPS
from grus.commands import main
from grus.errors import GrusError

ONE, TWO = Case(2, 1000, True), Case(3, 1000, True)


@pytest.fixture
def measured(monkeypatch):
    """Cases that were measured, instead of measuring them."""
    asked = []

    def measure(case, progress):
        asked.append(case)
        if case.elements == 999:
            raise KeyboardInterrupt
        for _ in range(8):
            progress()
        return [timing(loop, float(len(asked)), case) for loop in LOOPS]

    monkeypatch.setattr(import_module("grus.bench.bench"), "measure", measure)
    return asked


def test_what_the_folder_has_is_kept(tmp_path, measured):
    bench([TWO], tmp_path)
    found = bench([ONE, TWO], tmp_path)
    assert measured == [TWO, ONE]
    assert [t.case for t in found] == len(LOOPS) * [ONE] + len(LOOPS) * [TWO]
    assert read(tmp_path) == found
    assert {t.step for t in found if t.case == TWO} == {1.0}


def test_restart_forgets_what_the_folder_has(tmp_path, measured):
    bench([ONE, TWO], tmp_path)
    found = bench([TWO], tmp_path, restart=True)
    assert measured == [ONE, TWO, TWO]
    assert read(tmp_path) == found
    assert {t.case for t in found} == {TWO}


def test_a_case_without_a_loop_that_can_be_measured_is_measured_again(tmp_path, measured):
    write(tmp_path, [timing("grainloop", 1.0, ONE)])
    assert [t.loop for t in bench([ONE], tmp_path)] == list(LOOPS)


def test_progress_counts_rounds_of_what_is_missing(tmp_path, measured):
    shown = []
    bench([ONE, TWO], tmp_path, lambda done, of: shown.append((done, of)))
    assert shown == [(done, 16) for done in range(17)]
    shown.clear()
    bench([ONE, TWO], tmp_path, lambda done, of: shown.append((done, of)))
    assert not shown


def test_interrupted_measurement_keeps_what_it_has(tmp_path, measured, capsys):
    options = ["--dimension", "2", "--kind", "clumps", "--threads", "1"]
    command = ["bench", "--out", str(tmp_path), *options, "--elements", "1000", "--elements", "999"]
    assert main(command) == 130
    assert f"{tmp_path} has what was measured" in capsys.readouterr().err
    assert {t.case for t in read(tmp_path)} == {ONE}


def test_command_shows_the_table_and_names_its_file(tmp_path, measured, capsys):
    assert main(["bench", "--quick", "--out", str(tmp_path)]) == 0
    shown = capsys.readouterr().out
    assert "Grus" in shown and "3d_3000" in shown
    assert f"results in {tmp_path}: bench.json" in shown
    assert len(measured) == 3


def test_timings_of_other_engines_are_refused(tmp_path, measured):
    path = write(tmp_path, [timing("grainloop", 1.0)])
    content = json.loads(path.read_text())
    content["conditions"]["engines"] = "other"
    path.write_text(json.dumps(content))
    with pytest.raises(GrusError, match="bench.json: engines = other; .*--restart"):
        bench([ONE], tmp_path)
    bench([ONE], tmp_path, restart=True)


@pytest.mark.parametrize("content", ["", "[]", "{}", '{"conditions": [], "timings": [1]}'])
def test_damaged_file_is_refused(tmp_path, content, measured):
    (tmp_path / "bench.json").write_text(content)
    with pytest.raises(GrusError, match="bench.json cannot be read .*--restart"):
        bench([ONE], tmp_path)
    assert not measured


@pytest.mark.parametrize(
    "options, complaint",
    [
        ([], "missing option '--out'"),
        (["--out", "x", "--dimension", "4"], "4 is not in the range 2<=x<=3"),
        (["--out", "x", "--elements", "5"], "5 is not in the range x>=100"),
        (["--out", "x", "--threads", "0"], "0 is not in the range x>=1"),
        (["--out", "x", "--kind", "cubes"], "'cubes' is not one of"),
        (["--out", "x", "--quick", "--threads", "1"], "--quick has cases of its own"),
    ],
)
def test_wrong_options_are_refused(options, complaint, measured, capsys):
    assert main(["bench", *options]) == 2
    assert complaint in capsys.readouterr().err
    assert not measured


def test_file_instead_of_a_folder_is_refused(tmp_path, measured, capsys):
    (tmp_path / "file").touch()
    assert main(["bench", "--quick", "--out", str(tmp_path / "file")]) == 2
    assert str(tmp_path / "file") in capsys.readouterr().err
    assert not measured
