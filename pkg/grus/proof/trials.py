"""Trials on disk: a recording each, and answers that are opened after the diagnosis."""

import hashlib
import json
import tomllib
from dataclasses import dataclass
from pathlib import Path

from grus.errors import GrusError

SETS = {"all": "sealed", "quick": "sealed", "development": "development"}
"""Trials that can be asked for, and their folder."""
QUICK = 4
"""Trials of the quick set: the first of the sealed ones that share a program."""


@dataclass(frozen=True)
class Trial:
    """name: its number. recording: file. program: its stages, None when they are not labelled."""

    name: str
    recording: Path
    program: list[str] | None


def trials(folder: Path, which: str) -> list[Trial]:
    """The trials of a set in a folder such as validation/concealed/trials, by name. Raises GrusError when there are none."""
    if which not in SETS:
        raise GrusError(f"trials = {which!r}; allowed: {', '.join(SETS)}")
    found = []
    for recording in sorted((folder / SETS[which]).glob("*/recording.csv")):
        labels = recording.parent / "program.toml"
        program = tomllib.loads(labels.read_text())["stages"] if labels.exists() else None
        found.append(Trial(recording.parent.name, recording, program))
    if not found:
        raise GrusError(f"{folder / SETS[which]}: no trials; allowed: NUMBER/recording.csv")
    return _quick(found) if which == "quick" else found


def _quick(found: list[Trial]) -> list[Trial]:
    """The first few that have one labelled program, and so share their runs."""
    by_program: dict[tuple[str, ...], list[Trial]] = {}
    for trial in found:
        by_program.setdefault(tuple(trial.program or ()), []).append(trial)
    labelled = {stages: own for stages, own in by_program.items() if stages}
    most = max(labelled.values(), key=len, default=found)
    return most[:QUICK]


def answers(folder: Path, which: str) -> dict[str, dict]:
    """What is true of the trials of a set, by name. Raises GrusError when an answer is not the one that was sealed."""
    if SETS[which] == "development":
        return json.loads((folder / "development" / "answers.json").read_text())
    seals = json.loads((folder / "seals.json").read_text())
    opened = json.loads((folder / "answers.json").read_text())
    for name, one in opened.items():
        text = json.dumps(one["answer"], sort_keys=True, separators=(",", ":"))
        if hashlib.sha256((one["salt"] + text).encode()).hexdigest() != seals.get(name):
            raise GrusError(f"{folder}/answers.json: {name}: not the answer that was sealed")
    return {name: one["answer"] for name, one in opened.items()}
