"""Simulated tests of a recording's protocol, made by the campaign layer and kept in its store."""

import os
import time
from collections.abc import Callable, Iterable
from contextlib import ExitStack
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from distributed import Client

from grus.campaign import Outcome, Run, Store, campaign, workers
from grus.card import Card
from grus.diagnosis.base import Base
from grus.diagnosis.layout import simulated_stages
from grus.diagnosis.protocol import Protocol
from grus.mechanisms import MECHANISMS
from grus.record import Record

Say = Callable[[str], None]
TIME_LIMIT = 1800.0
"""Wall time of one run [s], far beyond what the steps that it is given take."""
CLOCKED = "bond_ageing"
"""Mechanism for which the laboratory clock matters. All other tests of the same stresses share their runs."""
WETTED = "wetting_collapse"


@dataclass(frozen=True)
class Test:
    """One simulated test: ordinary parameters, seed, and the mechanisms that are on, each with its parameters."""

    base: Base
    seed: int
    mechanisms: tuple[tuple[str, tuple[tuple[str, float], ...]], ...] = ()


class Simulator:
    """Runs tests of one card under one protocol.

    card: the small model. folder: of the store. jobs: runs at a time. deadline: `time.monotonic()` after which no
    run is begun, None for none. `outcomes` has all runs that have been asked for. A context manager: the workers of the
    campaigns are kept until its end.
    """

    def __init__(
        self,
        card: Card,
        protocol: Protocol,
        folder: str | Path,
        jobs: int | None = None,
        deadline: float | None = None,
        say: Say = lambda line: None,
    ) -> None:
        self.protocol, self.jobs, self.deadline, self.say = protocol, jobs, deadline, say
        self.store = Store(folder)
        # One platen, as in most laboratories: under wall friction the base then carries less than the top.
        self.card = card.with_overrides(
            {"oedometer.stages": list(protocol.timeless), "oedometer.platens": "top"}
        )
        self.outcomes: dict[Test, Outcome] = {}
        self._kept = ExitStack()
        self._client: Client | None = None

    def __enter__(self) -> "Simulator":
        return self

    def __exit__(self, *error: object) -> None:
        self._kept.close()

    def run(self, tests: Iterable[Test], what: str) -> dict[Test, Record]:
        """Records of the tests that came to an end; `what` names them to the user.

        An instrument that is part of the test's mechanism has written them. Those that failed, or were not begun
        before the deadline, are left out.
        """
        tests = list(dict.fromkeys(tests))
        runs = {
            test: Run("recording", self._card(test), specimen_card=self._specimen_card(test.seed))
            for test in tests
        }
        start = time.monotonic()
        if self._client is None and any(self.store.find(r.key) is None for r in runs.values()):
            jobs = self.jobs or len(os.sched_getaffinity(0))
            self._client = self._kept.enter_context(workers(jobs, tell=self.say))
        found = campaign(
            list(runs.values()),
            self.store,
            jobs=self.jobs,
            client=self._client,
            time_limit=TIME_LIMIT,
            deadline=self.deadline,
            progress=lambda done, of: self.say(f"{what}: {done} of {of} runs"),
            tell=self.say,
        )
        self.say(f"{what}: {len(runs)} runs, {time.monotonic() - start:.0f} s")
        records = {}
        for test, run in runs.items():
            outcome = found.get(run.key)
            if outcome is None:
                continue
            self.outcomes[test] = outcome
            if outcome.failed is None:
                records[test] = self._written(test, outcome.record)
        return records

    def _specimen_card(self, seed: int) -> Card:
        """All tests of a seed have one packing, whatever is changed in them."""
        return self.card.with_overrides({"seed": seed})

    def _card(self, test: Test) -> Card:
        highest = self.protocol.scale * self.protocol.highest
        card = test.base.apply(self.card, highest).with_overrides({"seed": test.seed})
        if CLOCKED in dict(test.mechanisms):
            card = card.with_overrides({"oedometer.stages": list(self.protocol.stages)})
        for name, values in test.mechanisms:
            more = {"time": self._wetting_time(card)} if name == WETTED else {}
            card = MECHANISMS[name].apply(card, more | dict(values))
        return card

    def _wetting_time(self, card: Card) -> float:
        """In the middle of the hold in which strain jumps [s]."""
        number = self.protocol.lead + self.protocol.jump.stage
        durations = [float(stage.duration) for stage in card.oedometer.stages]
        return sum(durations[:number]) + durations[number] / 2

    def _written(self, test: Test, record: Record) -> Record:
        record = retimed(record, self.protocol, WETTED in dict(test.mechanisms))
        record = rescaled(record, 1 / self.protocol.scale)
        for name, values in test.mechanisms:
            record = MECHANISMS[name].distort(record, dict(values))
        return record


def rescaled(simulated: Record, factor: float) -> Record:
    """A simulated test with all its stresses times a factor."""
    if factor == 1:
        return simulated
    stresses = {n: factor * simulated[n] for n in simulated.channels if simulated.units[n] == "Pa"}
    segments = tuple(
        replace(s, stress_from=factor * s.stress_from, stress_to=factor * s.stress_to)
        for s in simulated.segments
    )
    return replace(simulated, channels=simulated.channels | stresses, segments=segments)


def retimed(simulated: Record, program: Protocol, wetted: bool) -> Record:
    """A simulated test with the times of the recording at the ends of its stages, linear between.

    wetted: whether it was in the middle of the hold in which the strain of the recording jumps; it then has the time of
    the jump.
    """
    own, times = [], []
    for number, part in sorted(simulated_stages(simulated, program.lead).items()):
        follows = program.segments[number] if program.timed else part
        own.append(part.t0)
        times.append(follows.t0)
        if wetted and number == program.jump.stage:
            own.append((part.t0 + part.t1) / 2)
            share = (program.jump.before + program.jump.after) / 2
            times.append(follows.t0 + share * (follows.t1 - follows.t0))
        own.append(part.t1)
        times.append(follows.t1)
    # Before the recording the clock goes as it does in the simulation.
    time = simulated["time"]
    shown = np.where(time < own[0], times[0] + time - own[0], np.interp(time, own, times))
    segments = tuple(
        replace(s, t0=float(shown[s.first]), t1=float(shown[s.last])) for s in simulated.segments
    )
    return replace(simulated, channels=simulated.channels | {"time": shown}, segments=segments)
