"""What the studies of this folder share: the grains, the law, and results that are not computed twice."""

import json
import os
from collections.abc import Callable
from pathlib import Path

import grus

ROOT = Path(__file__).resolve().parents[2]
FIGURES = Path(__file__).resolve().parent / "figures"
RESULTS = Path(os.environ.get("GRUS_RESULTS", ROOT / "results")) / "validation-ageing"

EXPONENT = 20.0
LAW = {"law": "power", "exponent": EXPONENT, "referenceTime": 1.0}


def base() -> grus.Card:
    """The shipped card at twice its closing speed, which moves the peak forces by less than 1 %."""
    return grus.Card.from_file(ROOT / "models" / "montesinho.toml").with_overrides(
        {"crush.speed": "0.02 m/s"}
    )


def kept(name: str, make: Callable[[], dict]) -> dict:
    """What `make` gives, as JSON under results/validation-ageing; what is there already is not made again."""
    path = RESULTS / f"{name}.json"
    if not path.exists():
        found = make()
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(found))
        print(f"{name}: {found}", flush=True)
    return json.loads(path.read_text())
