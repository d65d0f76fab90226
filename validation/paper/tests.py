"""The oedometer tests of this folder: their cards and where their results lie."""

import os
from math import sqrt
from pathlib import Path

import grus

ROOT = Path(__file__).resolve().parents[2]
FIGURES = Path(__file__).resolve().parent / "figures"
RESULTS = Path(os.environ.get("GRUS_RESULTS", ROOT / "results")) / "validation-paper"
SPEEDS = (0.01, 0.5, 1.0, 2.0)  # m/s
SEEDS = (1, 2, 3)
ALL = 1520  # grains of the paper


def card(grains: int, seed: int, speed: float) -> grus.Card:
    """The shipped card with the box scaled to the number of grains; only the slowest test goes faster where nothing breaks."""
    scale = sqrt(grains / ALL)
    return grus.Card.from_file(ROOT / "models" / "montesinho.toml").with_overrides(
        {
            "seed": seed,
            "specimen.width": f"{0.500 * scale:.4f} m",
            "specimen.height": f"{0.474 * scale:.4f} m",
            "specimen.grains": grains,
            "oedometer.speed": f"{speed:g} m/s",
            "oedometer.fast_speed": f"{max(speed, 0.1):g} m/s",
        }
    )


def folder(grains: int, seed: int, speed: float) -> Path:
    return RESULTS / f"grains-{grains}-seed-{seed}-speed-{speed:g}"


def specimens() -> Path:
    """Prepared specimens, which the tests at all speeds share."""
    return RESULTS / "specimens"
