"""The effects of this generator, and its runs, which are kept."""

import hashlib
import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np

from curve import Curve
from instrument import Instrument

FOLDER = Path(__file__).resolve().parents[1]
ROOT = FOLDER.parents[1]
STORE = Path(os.environ.get("GRUS_RESULTS", ROOT / "results")) / "validation-concealed"
INSIDE = (
    "bond_ageing",
    "wall_friction",
    "platen_compliance",
    "hertzian_contact",
    "contact_plasticity",
    "rolling_resistance",
    "strength_scatter",
    "wetting_collapse",
    "loading_too_fast",
    "instrument_drift",
)
OUTSIDE = ("friction_wear", "grain_swelling", "temperature_cycles", "load_leak")
CHANNELS = ("base_stress", "lateral_stress", "ae_events")
INSTRUMENT = ("platen_compliance", "instrument_drift")  # what the gauge shows beside the specimen
TIME_LIMIT = 900  # of a run [s]
SPECIMENS = 3  # seeds of a material that are run without any effect


def simulate(base: dict, effects: dict, program: str, seed: int) -> Curve:
    """The test of one specimen, run unless it is kept."""
    acting = {name: given for name, given in effects.items() if name not in INSTRUMENT}
    curve = _kept({"base": base, "effects": acting, "program": program, "seed": seed})
    values = {k: v for name in INSTRUMENT for k, v in effects.get(name, {}).items()}
    return curve.with_strain(curve.strain + Instrument(**values).shown(curve.stress, curve.time))


def others(seed: int, count: int) -> list[int]:
    """Seeds of the specimens of the same material that are run without effects."""
    first = seed - seed % 10
    return [first + k for k in range(SPECIMENS)]


def _kept(job: dict) -> Curve:
    text = json.dumps(job, sort_keys=True)
    path = STORE / f"{hashlib.sha256(text.encode()).hexdigest()[:16]}.npz"
    if not path.exists():
        STORE.mkdir(parents=True, exist_ok=True)
        asked = path.with_suffix(".json")
        asked.write_text(text)
        places = os.pathsep.join([str(FOLDER), str(ROOT / "pkg")])
        environment = os.environ | {"PYTHONPATH": places, "OMP_NUM_THREADS": "1"}
        command = [sys.executable, "-m", "dem.run", str(asked), str(path)]
        with path.with_suffix(".log").open("w") as log:
            subprocess.run(
                command, env=environment, stdout=log, stderr=log, check=True, timeout=TIME_LIMIT
            )
    stored = np.load(path)
    return Curve(
        *(stored[name] for name in ("time", "stress", "strain", "stage")),
        {name: stored[name] for name in CHANNELS},
    )
