"""Scripts run by `yade` and by yade-batch: the same card, the same answer; refusals name table and line."""

import os
import shutil
import subprocess
from pathlib import Path

import grus  # first, since it loads YADE
import numpy as np
import pandas as pd
import pytest
from yade import O

from grus.errors import GrusError
from grus.script import arguments

ROOT = Path(__file__).parents[3]
PLANE = ROOT / "tests" / "cards" / "plane.toml"
EXAMPLE = ROOT / "models" / "strengths.txt"


@pytest.fixture
def line(tmp_path, monkeypatch):
    """Makes this process one that yade-batch runs with the last line of a table."""
    monkeypatch.chdir(tmp_path)

    def make(*lines: str) -> None:
        table = tmp_path / "table.txt"
        table.write_text("\n".join(lines) + "\n")
        monkeypatch.setenv("YADE_BATCH", f"{table}:{len(lines)}")

    return make


def test_line_overrides_its_card(line):
    line("card seed! bond.tensile_strength! grain", f"'{PLANE}' 3 '2MPa' 5")
    card, grain, folder = arguments(grain=0, folder=None)
    assert (card.seed, card.bond.tensile_strength, card.bond.shear_strength) == (3, 2e6, 1e6)
    assert grain == 5
    assert folder == "results/table/seed=3,bond.tensile_strength=2MPa" and Path(folder).is_dir()


def test_tables_are_those_of_yade(line):
    """Comments, values of the line above, and values that are left as they are."""
    line("# of a card", "card seed! thickness", f"'{PLANE}' 2**3 '3m'", "", "= = *  # thickness")
    card, folder = arguments(folder=".")
    assert (card.seed, card.thickness) == (8, 1)
    assert folder.endswith("seed=2**3__line=5__")
    assert "seed=2**3" in O.tags["params"]


def test_folder_may_be_a_column(line):
    line("card folder", f"'{PLANE}' 'mine'")
    assert arguments(folder=".")[1] == "mine" and Path("mine").is_dir()


@pytest.mark.parametrize(
    "lines, told",
    [
        (["seed", "1"], "card = None; allowed: a column card with the path of a card in quotes"),
        (["card", "1"], "card = 1; allowed: a column card"),
        (["card seed", f"'{PLANE}' 2MPa"], "2MPa; allowed: numbers, and text in quotes"),
        (["card bond.strength", f"'{PLANE}' 1"], "bond.strength"),
        (["card seed grain", f"'{PLANE}' 1 'a'"], "grain = 'a'; allowed: a whole number"),
        (["card seed", f"'{PLANE}' -1"], "seed = -1"),
    ],
)
def test_bad_lines_are_told(line, tmp_path, lines, told):
    line(*lines)
    with pytest.raises(GrusError) as error:
        arguments(grain=0, folder=None)
    message = str(error.value)
    assert told in message and "table.txt, line 2: " in message and "\n" not in message
    assert [path.name for path in tmp_path.iterdir()] == ["table.txt"]


def test_arguments_of_a_command_line(monkeypatch):
    monkeypatch.delenv("YADE_BATCH", raising=False)
    monkeypatch.setattr("sys.argv", ["crush.py", str(PLANE), "2"])
    card, grain, folder = arguments(grain=0, folder=None)
    assert (card.seed, grain, folder) == (1, 2, None)
    monkeypatch.setattr("sys.argv", ["crush.py"])
    with pytest.raises(GrusError, match=r"allowed: CARD \[GRAIN\] \[FOLDER\]"):
        arguments(grain=0, folder=None)
    monkeypatch.setattr("sys.argv", ["crush.py", str(PLANE), "x"])
    with pytest.raises(GrusError, match="grain = 'x'; allowed: a whole number"):
        arguments(grain=0)


def test_example_is_a_table(monkeypatch):
    monkeypatch.chdir(ROOT)
    monkeypatch.setenv("YADE_BATCH", f"{EXAMPLE}:6")
    card, _ = arguments(grain=0)
    assert card.bond.tensile_strength == 2e6


@pytest.mark.skipif(not shutil.which("yade-batch"), reason="yade-batch is not installed")
def test_yade_batch_crushes_as_grus_does(tmp_path):
    table = tmp_path / "grains.txt"
    table.write_text(f"card seed! grain!\n'{PLANE}' 2 1\n= 3 0\n")
    done = subprocess.run(
        ["yade-batch", "--log", f"{tmp_path}/@.log", table, ROOT / "scripts" / "crush.py"],
        cwd=tmp_path,
        env=os.environ | {"PYTHONPATH": str(ROOT / "pkg")},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    for seed, grain in ((2, 1), (3, 0)):
        name = f"seed={seed},grain={grain}"
        log = (tmp_path / f"{name}.log").read_text()
        expected = grus.crush(grus.Card.from_file(PLANE).with_overrides({"seed": seed}), grain)
        assert f"strength {expected.strength / 1e6:.7g} MPa" in log
        curve = pd.read_csv(
            tmp_path / "results" / "grains" / name / "curve.csv", float_precision="round_trip"
        )
        np.testing.assert_array_equal(curve["force [N]"], expected.record["force"])
