"""The oedometer tests of this folder: the quick card with a day's hold after each load, at constant stress."""

import os
from pathlib import Path

import grus
from grus.mechanisms import MECHANISMS
from grus.oedometer import OedometerResult, oedometer

ROOT = Path(__file__).resolve().parents[2]
FIGURES = Path(__file__).resolve().parent / "figures"
RESULTS = Path(os.environ.get("GRUS_RESULTS", ROOT / "results")) / "validation-creep"

LEVELS = (100, 200, 300, 400)
"""Axial stresses at which the specimen is held [kPa]."""
UNLOADED = 100
"""The stress of the last hold [kPa]."""
DAY = 86400.0
DAMPING = 0.2
"""Of the card it would hold back the stress on its way from the top to a fixed base."""


def stages() -> list[str]:
    """Loads in an hour each, and a day at rest after each."""
    steps = [f"load to {level} kPa in 1 h" for level in LEVELS]
    steps.append(f"unload to {UNLOADED} kPa in 1 h")
    return [stage for step in steps for stage in (step, "hold for 24 h")]


def card(seed: int = 1) -> grus.Card:
    """The quick card with these stages, over a base that is fixed as the ring is."""
    return grus.Card.from_file(ROOT / "models" / "quick.toml").with_overrides(
        {
            "oedometer.stages": stages(),
            "oedometer.platens": "top",
            "oedometer.damping": DAMPING,
            "seed": seed,
        }
    )


def run(card: grus.Card, mechanism: str | None, **values: float) -> OedometerResult:
    """The test of a card with one mechanism on, or with none, on the same packing; what is there already is not run again."""
    asked = card if mechanism is None else MECHANISMS[mechanism].apply(card, values)
    folder = RESULTS / f"test-{asked.content_hash()[:12]}"
    done = (folder / "done").exists()
    result = oedometer(asked, folder, specimens=RESULTS / "specimens", specimen_card=card)
    if not done:
        (folder / "done").touch()
        end = result.stages[-1]
        print(f"{mechanism} {values}: {end.breaks} breaks, {end.steps} steps", flush=True)
    return result
