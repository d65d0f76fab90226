"""The recipe for Slurm: its workers find what a campaign in this process finds, and end with it."""

import subprocess
from pathlib import Path

import numpy as np

import grus  # noqa: F401  loads YADE
from grus.campaign import Run, Store, campaign
from grus.card import Card

ROOT = Path(__file__).parents[3]
RECIPE = ROOT / "scripts" / "slurm-campaign"
PLANE = ROOT / "tests" / "cards" / "plane.toml"
SEEDS = 3


def recipe(environment: dict, folder: Path, *arguments: object) -> subprocess.CompletedProcess:
    return subprocess.run(
        list(map(str, [RECIPE, *arguments])),
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
    )


def test_workers_find_what_this_process_finds(slurm, tmp_path):
    sbatch = ["--array=1-2", "--cpus-per-task=1", "--time=10"]
    run = [PLANE, "--seeds", f"0-{SEEDS - 1}", "--out", tmp_path / "store"]
    done = recipe(slurm, tmp_path, *sbatch, "--", *run)
    assert done.returncode == 0, done.stderr
    assert "workers: job " in done.stderr
    card = Card.from_file(PLANE)
    runs = [Run("crush", card.with_overrides({"seed": seed})) for seed in range(SEEDS)]
    expected = campaign(runs, Store(tmp_path / "local"), jobs=1)
    found = {outcome.key: outcome for outcome in Store(tmp_path / "store").outcomes()}
    assert set(found) == set(expected)
    for key, outcome in found.items():
        assert outcome.failed is None and outcome.figures == expected[key].figures
        for name in expected[key].record.channels:
            np.testing.assert_array_equal(outcome.record[name], expected[key].record[name])
    assert {path.name for path in tmp_path.iterdir()} == {"store", "local"}  # nothing of its own


def test_what_slurm_refuses_is_told(slurm, tmp_path):
    done = recipe(slurm, tmp_path, "--partition=none", "--", PLANE, "--out", tmp_path / "store")
    assert done.returncode != 0 and "partition" in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_usage_is_told(tmp_path):
    done = recipe({"PATH": "/usr/bin:/bin"}, tmp_path, PLANE)
    assert done.returncode == 2 and done.stderr.count("\n") == 1 and "usage: " in done.stderr
    assert list(tmp_path.iterdir()) == []
