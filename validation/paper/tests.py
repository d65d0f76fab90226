"""The oedometer tests of this folder: their cards and where their results lie."""

import os
from math import sqrt
from pathlib import Path

import grus

ROOT = Path(__file__).resolve().parents[2]
RESULTS = Path(os.environ.get("GRUS_RESULTS", ROOT / "results")) / "validation-paper"
ALL = 1520  # grains of the paper
SEEDS = (1, 2, 3)
SPEEDS = (0.01, 0.5, 1.0, 2.0)  # m/s, those of the paper's rate study
PRINTED, CHOSEN = 1.0, 3.0  # strength of bonds [MPa]
VOID_RATIO = 0.25  # printed; specimens of fewer grains stand with it
FAST = 0.1  # m/s, of tests at an adaptive speed
GRAINS = 300
FIGURES = Path(__file__).resolve().parent / "figures"


def card(
    grains: int, seed: int, speed: float, strength: float, adaptive: bool = False
) -> grus.Card:
    """The shipped card with the box scaled to the number of grains, and the printed void ratio unless it has all grains.

    speed: of the platens [m/s]; `adaptive`: only where bonds break or the test is not quasi-static, else up to FAST.
    strength: of bonds in tension and in shear [MPa].
    """
    scale = sqrt(grains / ALL)
    full = grus.Card.from_file(ROOT / "models" / "montesinho.toml")
    return full.with_overrides(
        {
            "seed": seed,
            "specimen.width": f"{0.500 * scale:.4f} m",
            "specimen.height": f"{0.474 * scale:.4f} m",
            "specimen.grains": grains,
            "specimen.void_ratio": full.specimen.void_ratio if grains == ALL else VOID_RATIO,
            "bond.tensile_strength": f"{strength:g} MPa",
            "bond.shear_strength": f"{strength:g} MPa",
            "oedometer.speed": f"{speed:g} m/s",
            "oedometer.fast_speed": f"{FAST if adaptive else speed:g} m/s",
        }
    )


def packing(grains: int, seed: int) -> grus.Card:
    """The card of the prepared specimen, which tests at all speeds and strengths share."""
    return card(grains, seed, SPEEDS[0], PRINTED)


def folder(grains: int, seed: int, speed: float, strength: float, adaptive: bool = False) -> Path:
    """Where the results of a test lie."""
    how = "adaptive" if adaptive else f"speed-{speed:g}"
    return RESULTS / f"grains-{grains}-seed-{seed}-{how}-strength-{strength:g}"


def specimens() -> Path:
    """Prepared specimens."""
    return RESULTS / "specimens"
