"""The oedometer tests of this folder: their cards and where their results lie."""

import os
from math import sqrt
from pathlib import Path

import grus

ROOT = Path(__file__).resolve().parents[2]
RESULTS = Path(os.environ.get("GRUS_RESULTS", ROOT / "results")) / "validation-paper"
ALL = 1520  # grains of the paper


def card(grains: int, seed: int, speed: float, strength: float) -> grus.Card:
    """The shipped card with the box scaled to the number of grains; slow tests go at 0.1 m/s where nothing breaks.

    speed: of the platens [m/s]. strength: of bonds in tension and in shear [MPa]; 1 is printed.
    """
    scale = sqrt(grains / ALL)
    return grus.Card.from_file(ROOT / "models" / "montesinho.toml").with_overrides(
        {
            "seed": seed,
            "specimen.width": f"{0.500 * scale:.4f} m",
            "specimen.height": f"{0.474 * scale:.4f} m",
            "specimen.grains": grains,
            "bond.tensile_strength": f"{strength:g} MPa",
            "bond.shear_strength": f"{strength:g} MPa",
            "oedometer.speed": f"{speed:g} m/s",
            "oedometer.fast_speed": f"{max(speed, 0.1):g} m/s",
        }
    )


def folder(grains: int, seed: int, speed: float, strength: float) -> Path:
    """Where the results of a test lie."""
    return RESULTS / f"grains-{grains}-seed-{seed}-speed-{speed:g}-strength-{strength:g}"


def specimens() -> Path:
    """Prepared specimens, which the tests at all speeds share."""
    return RESULTS / "specimens"
