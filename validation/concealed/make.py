"""Makes the trials: recordings in which an effect is concealed, and their answers.

    python3 make.py constitutive development --seed 1
    python3 make.py dem development --seed 1          # some minutes of YADE
    python3 make.py demo                              # models/recordings/concealed-creep.csv
    python3 make.py constitutive sealed --seed S      # numbered at random; dem likewise

The seed of the sealed trials is in answers.json and nowhere else.
"""

import argparse
import hashlib
import importlib
import json
from pathlib import Path

import numpy as np

from conceal import recording
from seal import seal
from trial import answer, ratios, write

TRIALS = Path(__file__).resolve().parent / "trials"
DEMO = TRIALS.parents[2] / "models" / "recordings" / "concealed-creep.csv"
FIRST = {"constitutive": 1, "dem": 101}  # numbers of the trials; 100 more of the sealed ones


def development(name: str, seed: int) -> None:
    """Trials whose answers lie open, to set thresholds with."""
    plan = importlib.import_module(f"{name}.plan")
    generator = importlib.import_module(f"{name}.effects")
    folder = TRIALS / "development"
    answers = _stored("development/answers.json")
    for number, trial in enumerate(plan.trials("development", seed), FIRST[name]):
        curve, found = ratios(trial, generator)
        write(trial, curve, folder / f"{number:03d}")
        answers[f"{number:03d}"] = answer(trial, generator, found)
        print(number, trial.grade, trial.program, found, flush=True)
        _store("development/answers.json", answers)


def sealed(name: str, seed: int) -> None:
    """Trials in random order, their seals, and the answers that only the scorer opens."""
    plan = importlib.import_module(f"{name}.plan")
    generator = importlib.import_module(f"{name}.effects")
    made = []
    for trial in plan.trials("sealed", seed):
        curve, found = ratios(trial, generator)
        made.append((trial, curve, answer(trial, generator, found)))
        print(len(made), flush=True)
    seals, answers = _stored("seals.json"), _stored("answers.json")
    order = np.random.default_rng([seed, 7]).permutation(len(made))
    for number, index in enumerate(order, 100 + FIRST[name]):
        trial, curve, told = made[index]
        place = f"{number:03d}"
        write(trial, curve, TRIALS / "sealed" / place)
        salt = hashlib.sha256(f"{seed} {place}".encode()).hexdigest()
        answers[place] = {"salt": salt, "answer": told}
        seals[place] = seal(salt, told)
    _store("seals.json", seals)
    _store("answers.json", answers)


def _stored(name: str) -> dict:
    path = TRIALS / name
    return json.loads(path.read_text()) if path.exists() else {}


def _store(name: str, table: dict) -> None:
    (TRIALS / name).write_text(json.dumps(table, indent=1, sort_keys=True) + "\n")


def demonstration() -> None:
    """The shipped recording, and its answer beside those of the development trials."""
    from constitutive import effects, plan

    curve, found = ratios(plan.DEMONSTRATION, effects)
    table = recording(curve, plan.DEMONSTRATION.concealment, np.random.default_rng(4))
    DEMO.parent.mkdir(parents=True, exist_ok=True)
    table.to_csv(DEMO, index=False, lineterminator="\n")
    told = answer(plan.DEMONSTRATION, effects, found)
    _store("demo.json", told)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("what", choices=(*FIRST, "demo"))
    parser.add_argument("kind", nargs="?", default="development", choices=("development", "sealed"))
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    if given.what == "demo":
        demonstration()
    elif given.kind == "sealed":
        sealed(given.what, given.seed)
    else:
        development(given.what, given.seed)


if __name__ == "__main__":
    main()
