"""Groups of crushing tests that the studies of this folder share."""

import os
from pathlib import Path

import grus
from grus.crushing import GroupResult

ROOT = Path(__file__).resolve().parents[2]
FIGURES = Path(__file__).resolve().parent / "figures"
RESULTS = Path(os.environ.get("GRUS_RESULTS", ROOT / "results")) / "validation-crushing"


def base() -> grus.Card:
    """The shipped card at twice its closing speed, which moves the peak forces by less than 1 %."""
    return grus.Card.from_file(ROOT / "models" / "montesinho.toml").with_overrides(
        {"crush.speed": "0.02 m/s"}
    )


def crushed(name: str, card: grus.Card, grains: int) -> GroupResult:
    """A group under results/validation-crushing/NAME; what is there already is not run again."""
    print(f"{name}: {grains} grains", flush=True)
    return grus.crush_group(card, grains, RESULTS / name)
