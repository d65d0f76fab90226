"""`grus crush` as a user runs it."""

import json
import os
import signal
import subprocess
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
GRUS = ROOT / "scripts" / "grus"
CARD = ROOT / "models" / "montesinho.toml"


def grus(*arguments: object) -> subprocess.CompletedProcess:
    return subprocess.run([GRUS, *map(str, arguments)], capture_output=True, text=True, timeout=120)


def fast_card(folder: Path) -> Path:
    card = folder / "card.toml"
    lines = CARD.read_text().splitlines()
    card.write_text(
        "\n".join('speed = "0.1 m/s"' if line.startswith("speed") else line for line in lines)
    )
    return card


@pytest.fixture(scope="module")
def done(tmp_path_factory) -> tuple[Path, subprocess.CompletedProcess]:
    folder = tmp_path_factory.mktemp("crush")
    return folder / "out", grus("crush", fast_card(folder), "--grains", 4, "--out", folder / "out")


def test_writes_all_it_promises(done):
    out, process = done
    assert process.returncode == 0, process.stderr
    files = {path.name for path in out.iterdir()}
    for name in ("weibull", "force-displacement", "fragments"):
        assert {f"{name}.png", f"{name}.svg"} <= files
    assert {"result.json", "curves.csv", "vtk", "grains", "card.json"} <= files
    result = json.loads((out / "result.json").read_text())
    assert result["grains"] == 4
    assert {"modulus", "modulus_ci", "sigma0"} <= set(result["weibull"])
    assert not [name for name in files if name.startswith(".")]


def test_summary_says_where_and_what(done):
    out, process = done
    assert str(out) in process.stdout
    assert "Weibull" in process.stdout and "energy" in process.stdout


def test_more_grains_go_on_from_there(done, tmp_path):
    out, _ = done
    before = {path.name: path.stat().st_mtime_ns for path in (out / "grains").iterdir()}
    process = grus("crush", out.parent / "card.toml", "--grains", 5, "--out", out)
    assert process.returncode == 0, process.stderr
    after = {path.name: path.stat().st_mtime_ns for path in (out / "grains").iterdir()}
    assert len(after) == 5 and all(after[name] == stamp for name, stamp in before.items())


def test_another_card_in_the_same_folder_is_refused(done):
    out, _ = done
    process = grus("crush", CARD, "--grains", 4, "--out", out)
    assert process.returncode == 2
    assert len(process.stderr.strip().splitlines()) == 1
    assert "another card" in process.stderr


def test_wrong_card_leaves_nothing_behind(tmp_path):
    card = tmp_path / "bad.toml"
    card.write_text(CARD.read_text().replace('radius = "0.6 mm"', 'radius = "0.6 kg"'))
    process = grus("crush", card, "--out", tmp_path / "out")
    assert process.returncode == 2
    assert len(process.stderr.strip().splitlines()) == 1
    for part in ("bad.toml", "element.radius", "0.6 kg", "length"):
        assert part in process.stderr
    assert not (tmp_path / "out").exists()


def test_output_that_cannot_be_written_is_one_line(tmp_path):
    (tmp_path / "file").write_text("")
    process = grus("crush", CARD, "--grains", 3, "--out", tmp_path / "file")
    assert process.returncode == 2
    assert len(process.stderr.strip().splitlines()) == 1


@pytest.mark.parametrize("option", [("--grains", "0"), ("--grains", "many"), ("--jobs", "0")])
def test_impossible_options_are_refused(tmp_path, option):
    process = grus("crush", CARD, *option, "--out", tmp_path / "out")
    assert process.returncode == 2
    assert len(process.stderr.strip().splitlines()) == 1


def test_interrupted_run_goes_on(tmp_path):
    out = tmp_path / "out"
    command = [GRUS, "crush", CARD, "--grains", "40", "--jobs", "2", "--out", out]
    process = subprocess.Popen(
        list(map(str, command)),
        stderr=subprocess.PIPE,
        stdout=subprocess.PIPE,
        start_new_session=True,
    )
    while process.poll() is None and len(list(out.glob("grains/grain-*.h5"))) < 2:
        time.sleep(0.1)

    os.killpg(process.pid, signal.SIGINT)  # as Ctrl-C in a terminal does
    _, complaint = process.communicate(timeout=60)
    assert process.returncode == 130, complaint
    assert b"Traceback" not in complaint
    finished = len(list(out.glob("grains/grain-*.h5")))
    assert 2 <= finished < 40
    stamps = {path: path.stat().st_mtime_ns for path in out.glob("grains/grain-*.h5")}
    again = grus("crush", CARD, "--grains", finished, "--out", out)
    assert again.returncode == 0, again.stderr
    assert not list(out.glob("grains/.*"))
    assert all(path.stat().st_mtime_ns == stamp for path, stamp in stamps.items())


def test_a_key_that_is_set(tmp_path):
    """It takes the place of the card's, and the results say so."""
    out = tmp_path / "out"
    run = grus(
        "crush",
        fast_card(tmp_path),
        "--grains",
        2,
        "--set",
        "bond.tensile_strength=7 MPa",
        "--out",
        out,
    )
    assert run.returncode == 0, run.stderr
    assert "7000000" in json.dumps(json.loads((out / "result.json").read_text())["card"]["bond"])


@pytest.mark.parametrize(
    "setting, message",
    [
        (
            "bond.tensile_strength",
            "set = 'bond.tensile_strength'; allowed: a key and what it is set to",
        ),
        ("bond.tensile_strength=7 m", 'bond.tensile_strength = "7 m"'),
        ("bond.strength=7 MPa", "bond.strength"),
    ],
)
def test_bad_settings(tmp_path, setting, message):
    run = grus("crush", CARD, "--set", setting, "--out", tmp_path / "out")
    assert run.returncode == 2
    assert message in run.stderr and len(run.stderr.strip().splitlines()) == 1
    assert not (tmp_path / "out").exists()
