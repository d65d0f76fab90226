"""One trial: what acts, how it is concealed, its recording and its answer."""

import json
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

import numpy as np

from conceal import Concealment, recording
from curve import Curve
from programs import PROGRAMS
from ratio import effect_over_scatter

REPLICATES = 8
STRONG, WEAK = 2.5, 1.0  # ratio of effect over scatter that is aimed at


@dataclass(frozen=True)
class Trial:
    """grade: "single", "weak", "pair", "outside", "none" or "poor". effects: name -> parameters."""

    grade: str
    program: str
    base: dict[str, float]
    effects: dict[str, dict[str, float]]
    channels: tuple[str, ...]
    concealment: Concealment
    seed: int


def curves(trial: Trial, generator: ModuleType) -> tuple[Curve, dict[str, Curve], list[Curve]]:
    """The curve; the same without each of the effects; and other specimens without any."""

    def simulate(effects: dict, seed: int) -> Curve:
        found = generator.simulate(trial.base, effects, trial.program, seed)
        return found.without(*(set(generator.CHANNELS) - set(trial.channels)))

    on = simulate(trial.effects, trial.seed)
    without = {
        name: simulate({k: v for k, v in trial.effects.items() if k != name}, trial.seed)
        for name in trial.effects
    }
    others = [simulate({}, seed) for seed in generator.others(trial.seed, REPLICATES)]
    return on, without, others


def ratios(trial: Trial, generator: ModuleType) -> tuple[Curve, dict[str, dict[str, float]]]:
    """The curve, and how large each effect is beside seeds and noise."""
    on, without, others = curves(trial, generator)
    return on, {
        name: effect_over_scatter(on, off, others, trial.concealment)
        for name, off in without.items()
    }


def answer(trial: Trial, generator: ModuleType, found: dict[str, dict[str, float]]) -> dict:
    """What is sealed."""
    drifts = trial.concealment.drift and "instrument_drift" not in trial.effects
    return {
        "grade": trial.grade,
        "generator": generator.__name__.split(".")[0],
        "effects": [
            {"name": name, "in_library": name in generator.INSIDE, "parameters": values}
            | found[name]
            for name, values in trial.effects.items()
        ],
        # True of the recording too, but not what it is about: neither to be missed nor a false alarm.
        "tolerated": ["instrument_drift"] if drifts else [],
        "program": list(PROGRAMS[trial.program]),
        "base": trial.base,
        "channels": list(trial.channels),
        "concealment": trial.concealment.to_dict(),
        "seed": trial.seed,
    }


def write(trial: Trial, curve: Curve, folder: Path) -> None:
    """recording.csv, and program.toml when the stages are labelled."""
    folder.mkdir(parents=True, exist_ok=True)
    table = recording(curve, trial.concealment, np.random.default_rng([trial.seed, 99]))
    table.to_csv(folder / "recording.csv", index=False, lineterminator="\n")
    program = folder / "program.toml"
    program.unlink(missing_ok=True)
    if trial.concealment.labelled:
        # Stages in the words of a card; JSON's way to write a list of texts is TOML's too.
        program.write_text(f"stages = {json.dumps(PROGRAMS[trial.program], indent=4)}\n")
