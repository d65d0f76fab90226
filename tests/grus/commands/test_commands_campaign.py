"""`grus campaign` as a user runs it."""

import subprocess
from pathlib import Path

import pandas as pd
import pytest

ROOT = Path(__file__).parents[3]
CARD = ROOT / "tests" / "cards" / "plane.toml"


def grus(*arguments: object) -> subprocess.CompletedProcess:
    command = [ROOT / "scripts" / "grus", "campaign", *arguments]
    return subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=120)


def test_table_of_runs_goes_on_from_there(tmp_path):
    out = tmp_path / "store"
    first = grus(CARD, "--seeds", "1-2", "--out", out)
    assert first.returncode == 0, first.stderr
    assert "http://" in first.stderr and "strength MPa" in first.stdout and str(out) in first.stdout
    stamps = {path: path.stat().st_mtime_ns for path in (out / "runs").iterdir()}
    assert len(stamps) == 2
    second = grus(
        CARD, "--seeds", "1-2", "--set", "bond.tensile_strength=1 MPa,2 MPa", "--out", out
    )
    assert second.returncode == 0, second.stderr
    found = pd.read_csv(out / "runs.csv")
    assert list(found["bond.tensile_strength"]) == ["1 MPa", "1 MPa", "2 MPa", "2 MPa"]
    assert list(found["seed"]) == [1, 2, 1, 2]
    assert found["failed"].isna().all()
    assert len(list((out / "runs").iterdir())) == 4
    assert all(path.stat().st_mtime_ns == stamp for path, stamp in stamps.items())


def test_failed_runs_are_told(tmp_path):
    process = grus(CARD, "--out", tmp_path, "--kind", "recording", "--set", "specimen.void_ratio=3")
    assert process.returncode == 0, process.stderr
    assert "failed: " in process.stdout and "specimen" in process.stdout


@pytest.mark.parametrize(
    "options, complaint",
    [
        (("--seeds", "x"), "seeds = 'x'"),
        (("--set", "bond.tensile_strength=1 kg"), "bond.tensile_strength"),
        (("--vary", "crush.peak_drop=0.1..0.3", "--points", "3"), "points = 3"),
        (("--kind", "triaxial"), "triaxial"),
    ],
)
def test_nonsense_is_refused_before_anything_is_written(tmp_path, options, complaint):
    process = grus(CARD, "--out", tmp_path / "out", *options)
    assert process.returncode == 2
    assert len(process.stderr.strip().splitlines()) == 1 and complaint in process.stderr
    assert not (tmp_path / "out").exists()
