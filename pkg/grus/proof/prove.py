"""Judging trials, and then opening their answers."""

import json
from collections.abc import Callable
from functools import partial
from pathlib import Path

from grus.card import Card
from grus.diagnosis import diagnose
from grus.errors import GrusError, one_line
from grus.files import write_text
from grus.proof.score import Score, score
from grus.proof.trials import Trial, answers, trials

Show = Callable[[float, str], None]


def prove(
    folder: str | Path,
    which: str,
    card: Card,
    out: str | Path,
    jobs: int | None = None,
    budget: float | None = None,
    show: Show = lambda share, line: None,
) -> Score:
    """Diagnoses the trials of a set ("all", "quick" or "development") in `folder`, then scores them.

    Verdicts are kept in `out`; those that are there are not made again, and all trials share one store of runs. `budget`
    [s] is that of each trial. `show` is called with the share that is done and a line. Answers are read after the last
    verdict is written.
    Raises GrusError when there are no trials, or an answer is not the one that was sealed.
    """
    folder, out = Path(folder), Path(out)
    wanted = trials(folder, which)
    verdicts = {}
    for number, trial in enumerate(wanted, start=1):
        path = out / trial.name / "verdict.json"
        if not path.exists():
            name, share = f"trial {trial.name}", (number - 1) / len(wanted)
            say = partial(_say, show, share, name)
            _judge(trial, card, path, out / "runs", jobs, budget, say)
        verdicts[trial.name] = json.loads(path.read_text())
    found = score(answers(folder, which), verdicts)
    write_text(out / "score.json", json.dumps(found.to_dict(), indent=1) + "\n")
    return found


def _say(show: Show, share: float, name: str, line: str) -> None:
    show(share, f"{name}: {line}")


def _judge(
    trial: Trial,
    card: Card,
    path: Path,
    store: Path,
    jobs: int | None,
    budget: float | None,
    say: Callable[[str], None],
) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    try:
        found = diagnose(
            trial.recording,
            card,
            store,
            jobs=jobs,
            budget=budget,
            say=say,
            program=trial.program,
        ).to_dict()
    except GrusError as error:
        # A recording that cannot be judged counts as one about which nothing was said.
        found = {
            "verdict": "cannot_tell",
            "mechanisms": [],
            "probability": {},
            "error": one_line(error),
        }
    write_text(path, json.dumps(found, indent=1) + "\n")
