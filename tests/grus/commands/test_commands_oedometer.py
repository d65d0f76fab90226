"""`grus oedometer` as a user runs it."""

import json
import os
import signal
import subprocess
import time
from pathlib import Path

import pytest

from grus.commands.staged_progress import staged_progress

ROOT = Path(__file__).parents[3]
GRUS = ROOT / "scripts" / "grus"
CARD = ROOT / "tests" / "cards" / "plane.toml"


def card(folder: Path, **lines: str) -> Path:
    """The card for tests with other values of some keys; loads that break hardly anything unless told otherwise."""
    lines = {"stages": '["load to 40 kPa", "unload to 20 kPa"]'} | lines
    path = folder / "card.toml"
    path.write_text(
        "\n".join(
            f"{line.split()[0]} = {lines[line.split()[0]]}"
            if line and line.split()[0] in lines
            else line
            for line in CARD.read_text().splitlines()
        )
    )
    return path


def grus(*arguments: object) -> subprocess.CompletedProcess:
    command = [GRUS, "oedometer", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=300)


@pytest.fixture(scope="module")
def done(tmp_path_factory) -> tuple[Path, Path, subprocess.CompletedProcess]:
    """Card, folder and process of a whole test, with prepared specimens in a folder of their own."""
    folder = tmp_path_factory.mktemp("oedometer")
    path = card(folder)
    process = grus(path, "--out", folder / "out", "--specimens", folder / "specimens")
    return path, folder / "out", process


def test_writes_all_it_promises(done):
    _, out, process = done
    assert process.returncode == 0, process.stderr
    assert process.stdout.rstrip().endswith("vtk/") and f"results in {out}" in process.stdout
    names = {path.name for path in out.iterdir()}
    assert {"result.json", "curve.csv", "stages.csv", "grading.csv", "stages", "vtk"} <= names
    assert not [name for name in names if name.startswith(("specimen", "."))]
    assert len(list((out.parent / "specimens").glob("specimen-*.h5"))) == 1
    assert json.loads((out / "result.json").read_text())["bonds"]["initial"] > 0


def test_progress_is_plain_lines_where_there_is_no_terminal(done):
    lines = done[2].stderr.splitlines()
    assert "\x1b" not in done[2].stderr and "\r" not in done[2].stderr
    assert any("growing exo-spheres" in line for line in lines)
    assert any("load to 40 kPa" in line and "bonds broken" in line for line in lines)
    assert all(line.split("%")[0].strip().isdigit() for line in lines)


@pytest.mark.parametrize("option", [[], ["--resume"]])
def test_finished_test_only_writes_its_report_again(done, option):
    path, out, first = done
    (out / "result.json").unlink()
    process = grus(path, "--out", out, "--specimens", out.parent / "specimens", *option)
    assert process.returncode == 0 and process.stdout == first.stdout
    assert process.stderr == "" and (out / "result.json").exists()


def test_restart_runs_the_test_again(done):
    path, out, first = done
    specimens = out.parent / "specimens"
    process = grus(path, "--out", out, "--specimens", specimens, "--restart")
    assert process.returncode == 0 and process.stdout == first.stdout
    assert "load to 40 kPa" in process.stderr and "growing" not in process.stderr


@pytest.mark.parametrize("option", [[], ["--restart"]])
def test_folder_of_another_card_is_refused(done, tmp_path, option):
    _, out, _ = done
    process = grus(card(tmp_path, seed="3"), "--out", out, *option)
    assert process.returncode == 2
    assert process.stderr == (
        f"grus: {out}: holds results of another card or version; allowed: an empty folder, or the same card\n"
    )
    assert (out / "stages" / "stage-002.h5").exists()


@pytest.mark.parametrize(
    "change, words",
    [
        ({"stages": '["load to 100 kPa", "load to 40 kPa"]'}, ("oedometer.stages", "stage 2")),
        ({"stages": '"load to 100 kPa"'}, ("oedometer.stages", "a list of 1 to")),
        ({"void_ratio": "30"}, ("specimen.void_ratio", "30")),
        ({"void_ratio": "0.6"}, ("allowed: ",)),
    ],
)
def test_what_cannot_be_run_leaves_nothing_behind(tmp_path, change, words):
    process = grus(card(tmp_path, **change), "--out", tmp_path / "out")
    assert process.returncode == 2
    complaint = process.stderr.splitlines()[-1]
    assert complaint.startswith("grus: ") and all(word in complaint for word in words)
    assert not (tmp_path / "out").exists()


def test_card_without_an_oedometer(tmp_path):
    process = grus(ROOT / "models" / "montesinho-3d.toml", "--out", tmp_path / "out")
    assert process.returncode == 2 and len(process.stderr.splitlines()) == 1
    assert "is missing; allowed: a table" in process.stderr


def test_interrupt_says_how_to_go_on(done, tmp_path):
    stages = '["load to 100 kPa", "load to 300 kPa", "unload to 40 kPa"]'
    path, out = card(tmp_path, stages=stages), tmp_path / "out"
    command = [GRUS, "oedometer", path, "--out", out, "--specimens", done[1].parent / "specimens"]
    process = subprocess.Popen(
        list(map(str, command)), stderr=subprocess.PIPE, text=True, start_new_session=True
    )
    while not (out / "stages" / "stage-000.h5").exists() and process.poll() is None:
        time.sleep(0.02)
    os.killpg(process.pid, signal.SIGINT)  # as Ctrl-C in a terminal does
    _, said = process.communicate(timeout=60)
    assert process.returncode == 130 and "Traceback" not in said
    last = said.splitlines()[-1]
    assert last.startswith("grus: interrupted in stage")
    assert last.endswith(f"saved in {out}/stages, start it again to go on from there")


def test_lines_are_few(capsys):
    with staged_progress() as show:
        for step in range(1000):
            show(step / 1000, f"load to 100 kPa: {step}")
        show(1.0, "unload to 40 kPa: 1")
    lines = capsys.readouterr().err.splitlines()
    assert 15 <= len(lines) <= 25
    assert lines[0] == "  0%, load to 100 kPa: 0" and "unload" in lines[-1]
    assert all(" left, " in line for line in lines[2:])
