"""`grus diagnose`."""

import json

import pytest
from soil import CARD, STAGES, Soil, without_dem

from grus.commands import main
from grus.commands.diagnosis_progress import DiagnosisProgress


@pytest.fixture
def formulas(monkeypatch):
    """Instead of the DEM."""
    without_dem(monkeypatch)


def run(recording, out, *more):
    return main(["diagnose", str(recording), "--model", str(CARD), "--out", str(out), *more])


def test_it_prints_the_verdict_and_writes_the_files(capsys, recording, tmp_path, formulas):
    program = tmp_path / "program.toml"
    program.write_text(f"stages = {json.dumps(STAGES)}\n")
    assert run(recording, tmp_path / "out", "--program", str(program), "--height", "50 mm") == 0
    captured = capsys.readouterr()
    assert captured.out.startswith("The model leaves out static fatigue of bonds.")
    assert len(captured.out.splitlines()) <= 27 and "report.html" in captured.out
    assert "calibrating stiffness" in captured.err and "left" in captured.err
    stored = json.loads((tmp_path / "out" / "verdict.json").read_text("utf-8"))
    assert stored["verdict"] == "named" and len(stored["recording"]["sha256"]) == 64
    assert stored["recording"]["name"] == "creep.csv"


def test_ctrl_c_says_what_is_kept(capsys, recording, tmp_path, monkeypatch, formulas):
    def stop(self, tests, what):
        raise KeyboardInterrupt

    monkeypatch.setattr(Soil, "run", stop)
    assert run(recording, tmp_path / "out") == 130
    said = capsys.readouterr().err
    assert f"finished runs are kept in {tmp_path / 'out' / 'runs'}" in said
    assert "goes on from there" in said and len(said.splitlines()) == 1


@pytest.mark.parametrize(
    "more, said",
    [
        (["--program", "none.toml"], "none.toml: cannot be read"),
        (["--height", "20 kPa"], "height"),
        (["--jobs", "0"], "jobs"),
        (["--budget", "-1"], "budget"),
        (["--seed", "0"], "seed"),
    ],
)
def test_refused_in_one_line(capsys, recording, tmp_path, monkeypatch, more, said):
    monkeypatch.chdir(tmp_path)
    assert run(recording, tmp_path / "out", *more) == 2
    captured = capsys.readouterr()
    assert captured.out == "" and len(captured.err.splitlines()) == 1 and said in captured.err
    assert list(tmp_path.iterdir()) == []


def test_bad_files_are_refused(capsys, recording, tmp_path):
    bad = tmp_path / "bad.csv"
    bad.write_text("time [kPa], axial_stress [kPa], axial_strain [%]\n1,2,3\n2,3,4\n")
    assert run(bad, tmp_path / "out") == 2
    assert "bad.csv" in capsys.readouterr().err
    program = tmp_path / "program.toml"
    program.write_text("stages = 1\n")
    assert run(recording, tmp_path / "out", "--program", str(program)) == 2
    assert "program.toml: stages is missing" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_progress_never_falls_and_tells_each_line():
    told = []
    say = DiagnosisProgress(lambda share, line: told.append((share, line)))
    lines = ["calibrating strength: 1 of 2 runs", "calibrating strength: 0 of 2 runs"]
    for line in [
        *lines,
        "a specimen is prepared",
        "fingerprints: 40 of 40 runs",
        "base: 0 of 6 runs",
    ]:
        say(line)
    shares = [share for share, _ in told]
    assert shares == sorted(shares) and 0 < shares[0] and shares[-1] <= 1 and len(told) == 5
