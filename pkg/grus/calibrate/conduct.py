"""The calibration: trials one group after the other, each group a campaign."""

import os
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path

import optuna
from distributed import Client

from grus.calibrate.answers import Answer, answers, runs_of
from grus.calibrate.calibration import Calibration, changed
from grus.calibrate.intervals import intervals
from grus.calibrate.local import local
from grus.calibrate.misfit import misfit
from grus.calibrate.search import FIRST, Search
from grus.calibrate.targets import Targets
from grus.calibrate.trial import Trial
from grus.campaign import Outcome, Run, Store, campaign, workers
from grus.campaign.store import Tell, quiet
from grus.card import Card
from grus.card.errors import CardError
from grus.errors import GrusError

Progress = Callable[[int, int], None]
GROUP = 4
"""Trials that are simulated together, and of which the local model proposes one. Not the number of workers, on which no
result may depend."""
STORE = "store"
"""Folder of the campaigns in that of the results."""


def calibrate(
    card: Card,
    targets: Targets,
    folder: str | Path,
    trials: int = 40,
    jobs: int | None = None,
    scheduler: str | None = None,
    progress: Progress | None = None,
    tell: Tell = quiet,
) -> Calibration:
    """Parameters of `card` with which it comes closest to `targets`, the best of so many trials.

    All simulations are runs of campaigns whose store is in `folder`. A call that was cut off goes on where it was, and
    one with more trials goes on from the last. jobs, scheduler, tell: as of `grus.campaign.campaign`. `progress(done,
    of)` is called after each simulation.
    Raises GrusError when no trial shows any of the targets, and as `campaign`.
    """
    if trials < 1:
        raise GrusError(f"trials = {trials}; allowed: 1 or more")
    search = Search(targets.parameters, card.seed)
    made: list[Trial] = []
    with _Simulations(Store(Path(folder) / STORE), jobs, scheduler, tell) as simulations:
        while len(made) < trials:
            if len(made) >= FIRST and (around := local(targets, made)):
                search.propose(around.minimum())
            asked = [search.ask() for _ in range(min(GROUP, trials - len(made)))]
            planned = [_plan(card, targets, shares) for _, shares in asked]
            wanted = [run for _, runs in planned for group in runs.values() for run in group]
            outcomes = simulations.run(wanted, len(made), len(asked), trials, progress)
            for (number, shares), (values, runs) in zip(asked, planned):
                found = answers(targets, runs, outcomes) if runs else _refused(targets)
                made.append(Trial(number + 1, shares, values, found, misfit(targets, found)))
                search.tell(number, made[-1].misfit)
        ended = simulations.ended
    _check(made)
    failed = sum(one.failed is not None for one in ended.values())
    versions = next((one.versions for one in ended.values() if one.versions), {})
    return Calibration(
        card,
        targets,
        tuple(made),
        intervals(targets, made),
        len(ended),
        failed,
        versions | {"optuna": optuna.__version__},
    )


def _plan(
    card: Card, targets: Targets, shares: tuple[float, ...]
) -> tuple[tuple[float, ...], dict[str, list[Run]]]:
    """Values of the parameters and runs by kind; no runs when the card refuses the values together."""
    values = tuple(one.value(share) for one, share in zip(targets.parameters, shares))
    try:
        return values, runs_of(changed(card, targets, values), card, targets)
    except CardError:
        return values, {}


def _refused(targets: Targets) -> dict[str, Answer]:
    return {one.name: Answer(missing="refused by the card") for one in targets.targets}


def _check(trials: list[Trial]) -> None:
    """Whether any trial shows any target."""
    reasons = [answer.missing for trial in trials for answer in trial.answers.values()]
    if None not in reasons:
        raise GrusError(
            f"no trial shows any target, the first: {reasons[0]}; allowed: other bounds"
        )


@dataclass
class _Simulations:
    """Campaigns with one store and, from the first that has something to simulate, the same workers."""

    store: Store
    jobs: int | None
    scheduler: str | None
    tell: Tell
    ended: dict[str, Outcome] = field(default_factory=dict)
    _kept: ExitStack = field(default_factory=ExitStack)
    _client: Client | None = None

    def __enter__(self) -> "_Simulations":
        return self

    def __exit__(self, *error: object) -> None:
        self._kept.close()

    def run(
        self, runs: list[Run], before: int, trials: int, of: int, progress: Progress | None
    ) -> dict[str, Outcome]:
        """Outcomes of the runs of so many `trials`; for the progress, `before` of them are over and there are `of`."""
        each = max(1, len({run.key for run in runs}) // trials)

        def show(done: int, _: int) -> None:
            if progress:
                progress(min(before * each + done, of * each), of * each)

        if self._client is None and not all(self.store.path(run.key).exists() for run in runs):
            jobs = self.jobs or len(os.sched_getaffinity(0))
            self.store.make()
            self._client = self._kept.enter_context(workers(jobs, self.scheduler, self.tell))
        found = campaign(
            runs,
            self.store,
            self.jobs,
            self.scheduler,
            progress=show,
            tell=self.tell,
            client=self._client,
        )
        self.ended |= found
        return found
