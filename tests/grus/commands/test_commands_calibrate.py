"""`grus calibrate` as a user runs it, on a few grains of few elements."""

import json
import os
import signal
import subprocess
import time
from pathlib import Path

import pandas as pd
import pytest

from grus.card import Card

ROOT = Path(__file__).parents[3]
CARD = ROOT / "tests" / "cards" / "plane.toml"
TARGETS = """
grains = 5
[parameters]
bond.tensile_strength = { low = "0.5 MPa", high = "4 MPa", logarithmic = true, tied = ["bond.shear_strength"] }
[targets]
characteristic_strength = { value = "2 MPa", tolerance = "0.2 MPa" }
weibull_modulus = { value = 4, tolerance = 1 }
"""


def grus(*arguments: object) -> subprocess.CompletedProcess:
    command = [ROOT / "scripts" / "grus", *arguments]
    return subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=300)


@pytest.fixture(scope="module")
def done(tmp_path_factory) -> tuple[Path, subprocess.CompletedProcess]:
    folder = tmp_path_factory.mktemp("calibrate")
    (folder / "targets.toml").write_text(TARGETS)
    out = folder / "out"
    return out, grus("calibrate", CARD, folder / "targets.toml", "--trials", 5, "--out", out)


def test_writes_all_it_promises(done):
    out, process = done
    assert process.returncode == 0, process.stderr
    assert "http://" in process.stderr and str(out) in process.stdout
    for text in ("bond.tensile_strength", "Weibull modulus", "characteristic strength", "misfit"):
        assert text in process.stdout
    found = json.loads((out / "result.json").read_text())
    assert all((out / name).exists() for name in found["files"])
    assert found["runs"] == 25 and found["failed_runs"] == 0
    assert set(found["versions"]) == {"grus", "yade", "python", "optuna"}
    assert len(found["trials"]) == len(pd.read_csv(out / "trials.csv")) == 5
    fitted = found["parameters"]["bond.tensile_strength"]
    assert 5e5 <= fitted["interval"][0] <= fitted["value"] <= fitted["interval"][1] <= 4e6
    assert found["misfit"] == min(one["misfit"] for one in found["trials"])
    assert not [path for path in out.iterdir() if path.name.startswith(".")]


def test_calibrated_card_gives_what_was_found(done, tmp_path):
    out, _ = done
    found = json.loads((out / "result.json").read_text())
    card = Card.from_file(out / "calibrated.toml")
    assert card.content_hash() == found["card_hash"]
    assert float(card.bond.shear_strength) == found["parameters"]["bond.tensile_strength"]["value"]
    process = grus("crush", out / "calibrated.toml", "--grains", 5, "--out", tmp_path)
    assert process.returncode == 0, process.stderr
    weibull = json.loads((tmp_path / "result.json").read_text())["weibull"]
    assert weibull["sigma0"] == found["targets"]["characteristic_strength"]["model"]
    assert weibull["modulus"] == found["targets"]["weibull_modulus"]["model"]


def test_second_call_simulates_nothing(done):
    out, _ = done
    stamps = {path: path.stat().st_mtime_ns for path in (out / "store" / "runs").iterdir()}
    before = (out / "result.json").read_text()
    process = grus("calibrate", CARD, out.parent / "targets.toml", "--trials", 5, "--out", out)
    assert process.returncode == 0, process.stderr
    assert "http://" not in process.stderr
    assert (out / "result.json").read_text() == before
    assert {path: path.stat().st_mtime_ns for path in (out / "store" / "runs").iterdir()} == stamps


def test_page(done):
    out, _ = done
    process = grus("report", out)
    assert process.returncode == 0, process.stderr
    page = (out / "report.html").read_text("utf-8")
    for text in ("Calibration: plane", "bond.tensile_strength", "Weibull modulus", "optuna"):
        assert text in page
    assert page.count('src="data:image') == 2


def test_interrupted_search_goes_on(done, tmp_path):
    whole, _ = done
    out = tmp_path / "out"
    targets = whole.parent / "targets.toml"
    command = [ROOT / "scripts" / "grus", "calibrate", CARD, targets, "--trials", 5]
    process = subprocess.Popen(
        list(map(str, [*command, "--jobs", 1, "--out", out])),
        stderr=subprocess.PIPE,
        stdout=subprocess.PIPE,
        process_group=0,
    )
    for _ in range(2000):
        if list(out.glob("store/runs/*.h5")):
            break
        time.sleep(0.1)
    os.killpg(process.pid, signal.SIGINT)  # as Ctrl-C in a terminal does
    _, complaint = process.communicate(timeout=120)
    assert process.returncode == 130, complaint
    assert b"Traceback" not in complaint and b"goes on from there" in complaint
    assert not (out / "result.json").exists()
    assert 1 <= len(list(out.glob("store/runs/[0-9a-f]*.h5"))) < 25
    again = grus("calibrate", CARD, targets, "--trials", 5, "--out", out)
    assert again.returncode == 0, again.stderr
    assert (out / "result.json").read_text() == (whole / "result.json").read_text()


@pytest.mark.parametrize(
    "text, complaint",
    [
        (None, "targets.toml: cannot be read"),
        ("[targets", "targets.toml: not valid TOML"),
        (TARGETS.replace("4 MPa", "4 m"), "bond.tensile_strength.high"),
        (TARGETS.replace("modulus = {", "module = {"), "targets.weibull_module"),
    ],
)
def test_nonsense_is_refused_before_anything_is_written(tmp_path, text, complaint):
    if text is not None:
        (tmp_path / "targets.toml").write_text(text)
    process = grus("calibrate", CARD, tmp_path / "targets.toml", "--out", tmp_path / "out")
    assert process.returncode == 2
    assert len(process.stderr.strip().splitlines()) == 1 and complaint in process.stderr
    assert not (tmp_path / "out").exists()
