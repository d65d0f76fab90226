"""The oedometer tests of this folder: the quick card at one speed, or at an adaptive one."""

import json
import os
from pathlib import Path

import grus
import numpy as np
from grus.files import write_text
from grus.oedometer.program import program
from grus.oedometer.run import SEATING
from grus.oedometer.test import OedometerTest, ledger, record, servo
from grus.preparation import prepare
from yade import O

ROOT = Path(__file__).resolve().parents[2]
FIGURES = Path(__file__).resolve().parent / "figures"
RESULTS = Path(os.environ.get("GRUS_RESULTS", ROOT / "results")) / "validation-adaptive-speed"
SEEDS = (1, 2, 3)
SLOW, FAST = 0.01, 0.1  # m/s; the first is that of the paper
DAMPING = 0.2
"""Local damping of the tests that README.md is about; the card has more."""
READINGS = {"recordStrain": 1e-6, "recordStress": 1e-3}
"""Attributes of the servo: dense enough to say what the steps are spent on."""


def card(seed: int) -> grus.Card:
    """Forty grains, loaded to 400 kPa and unloaded."""
    return grus.Card.from_file(ROOT / "models" / "quick.toml").with_overrides(
        {
            "seed": seed,
            "oedometer.speed": f"{SLOW} m/s",
            "oedometer.fast_speed": f"{SLOW} m/s",
            "oedometer.damping": DAMPING,
        }
    )


def tested(name: str, seed: int, **controller: float) -> list[dict]:
    """A row a stage, the seating first, of the test with these attributes of OedometerServo; kept under results.

    steps: of the stage; waiting: those after the stress was first within the tolerance; slow: those of the others at whose
    end, in the record, the speed limit was not above that of breakage.
    """
    path = RESULTS / f"{name}-{seed}.json"
    if path.exists():
        return json.loads(path.read_text())
    print(f"{name}, seed {seed}", flush=True)
    model = card(seed)
    prepared = prepare(model, RESULTS / "specimens")
    OedometerTest(model, prepared)
    control, begin = servo(), O.iter
    for attribute, value in (READINGS | controller).items():
        setattr(control, attribute, value)
    rows = []
    for number, stage in enumerate(program(model)):
        control.tolerance = SEATING if number == 0 else model.oedometer.tolerance
        control.begin(stage.stress)
        O.run(-1, True)
        rows.append(
            {
                "stage": f"{stage.kind} {stage.stress / 1e3:g} kPa",
                "void_ratio": control.voidRatio,
                "broken": ledger().breaks,
                "K0": control.K0,
            }
            | _steps(number, stage.stress, control.tolerance, begin)
        )
        begin = O.iter
    rows[0]["bonds"] = len(prepared.specimen.bonds())
    path.parent.mkdir(parents=True, exist_ok=True)
    write_text(path, json.dumps(rows, indent=1) + "\n")
    return rows


def _steps(number: int, target: float, tolerance: float, begin: int) -> dict[str, int]:
    found = record()
    mine = found["stage"] == number
    step, speed = found["iter"][mine], found["speed_limit"][mine]
    stress = (found["top_stress"][mine] + found["bottom_stress"][mine]) / 2
    first = int(np.argmax(abs(stress / target - 1) <= tolerance))
    spans = np.diff(step, prepend=begin)
    return {
        "steps": int(step[-1] - begin),
        "waiting": int(step[-1] - step[first]),
        "slow": int(spans[: first + 1][speed[: first + 1] <= SLOW].sum()),
    }
