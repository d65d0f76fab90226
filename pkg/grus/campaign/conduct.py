"""Running what is missing."""

import os
import time
from collections.abc import Callable, Sequence
from contextlib import nullcontext

from distributed import CancelledError, Client, Future, KilledWorker, as_completed

from grus.campaign.attend import Report, attend_specimen, attend_test, failure
from grus.campaign.cluster import workers
from grus.campaign.job import SPECIMEN, Job
from grus.campaign.outcome import Outcome
from grus.campaign.run import OF_SPECIMENS, Run
from grus.campaign.store import Store, Tell, quiet
from grus.errors import GrusError
from grus.preparation.preparation import specimen_key

Progress = Callable[[int, int], None]
Ended = Callable[[Outcome], None]


def campaign(
    runs: Sequence[Run],
    store: Store,
    jobs: int | None = None,
    scheduler: str | None = None,
    time_limit: float | None = None,
    memory_limit: int | None = None,
    progress: Progress | None = None,
    ended: Ended | None = None,
    deadline: float | None = None,
    tell: Tell = quiet,
    client: Client | None = None,
) -> dict[str, Outcome]:
    """Outcomes of `runs` by their keys, in their order; what is in `store` is not simulated again.

    Each run has a process of its own with one thread, `jobs` at a time (default: one a core) on this machine, or as many
    as the workers of the Dask `scheduler` (its address or file) have threads; these must see the folder of the store under the same name.
    `client`, of `workers`, has them for several campaigns. Runs begin in the order of `runs`, none after `deadline` (`time.monotonic()` then): what was not begun is not
    in the result. A process that breaks is followed by one more; a run that fails does not stop the others, and is
    tried again by the next campaign unless its card is to blame.
    time_limit [s] and memory_limit [bytes] are those of one process. By default there is no time limit, and processes
    of this machine share its memory in equal parts. `ended(outcome)` is called with each outcome as soon as it is there, at
    once with those that need no run; then `progress(done, of)`; `tell(line)` when there is something to say.
    Raises GrusError for bad limits, and when the scheduler cannot be reached or is lost; OSError when the store cannot
    be written. What is finished then, or at Ctrl-C, stays in the store.
    """
    jobs = jobs or len(os.sched_getaffinity(0))
    for name, value in {
        "jobs": jobs,
        "time_limit": time_limit,
        "memory_limit": memory_limit,
    }.items():
        if value is not None and value <= 0:
            raise GrusError(f"{name} = {value}; allowed: above 0")
    store.make()
    wanted = {run.key: run for run in runs}
    found = {key: outcome for key in wanted if (outcome := store.find(key, tell))}
    missing = {key: run for key, run in wanted.items() if key not in found or not found[key].final}
    ended = ended or (lambda outcome: None)
    for key in wanted:
        if key not in missing:
            ended(found[key])
    count = _Count(len(wanted) - len(missing), len(wanted), progress)
    if missing:
        if memory_limit is None and scheduler is None:
            memory_limit = _memory() // jobs
        until = None if deadline is None else time.time() + deadline - time.monotonic()
        limits = {"time_limit": time_limit, "memory_limit": memory_limit, "until": until}
        given = client and nullcontext(client)
        try:
            with given or workers(min(jobs, len(missing)), scheduler, tell) as at:
                for key, report in _reports(at, missing, store, limits, tell, scheduler):
                    if report.begun:
                        found[key] = store.find(key, tell) or failure(
                            _job(missing[key], store, limits), report
                        )
                        ended(found[key])
                    count.one_more()
        except OSError as error:
            # Dask's own, of a connection that is gone, has no number; that of a full disk has.
            if scheduler is None or error.errno is not None:
                raise
            raise _lost(scheduler) from None
    return {key: found[key] for key in wanted if key in found}


class _Count:
    """Runs that are over."""

    def __init__(self, done: int, of: int, progress: Progress | None) -> None:
        self.done, self.of, self.progress = done, of, progress or (lambda done, of: None)
        self.progress(done, of)

    def one_more(self) -> None:
        self.done += 1
        self.progress(self.done, self.of)


def _reports(client: Client, runs: dict[str, Run], store: Store, limits: dict, tell, scheduler):
    """Key and report of each run as it ends."""
    futures = _submit(client, runs, store, limits)
    told: set[str] = set()
    try:
        for future in as_completed(futures):
            report = _report(future, scheduler)
            for line in report.lines:
                if line not in told:
                    tell(line)
            told.update(report.lines)
            yield futures[future], report
    except BaseException:
        if client.status == "running":  # not when the scheduler is lost
            client.cancel(list(futures))
        raise


def _submit(client: Client, runs: dict[str, Run], store: Store, limits: dict) -> dict[Future, str]:
    """A task a run, and one a specimen on which all runs that need it wait."""
    specimens: dict[str, Future] = {}
    futures = {}
    for number, (key, run) in enumerate(runs.items()):
        job = _job(run, store, limits)
        needed = []
        if run.kind in OF_SPECIMENS:
            name = specimen_key(run.prepared_by)
            if name not in specimens:
                card = run.prepared_by.to_dict()
                asked = Job(**{**vars(job), "kind": SPECIMEN, "key": name, "card": card})
                specimens[name] = client.submit(
                    attend_specimen, asked, pure=False, priority=-number
                )
            needed = [specimens[name]]
        future = client.submit(attend_test, job, *needed, pure=False, priority=-number)
        futures[future] = key
    return futures


def _report(future: Future, scheduler: str | None) -> Report:
    try:
        return future.result()
    except KilledWorker as error:
        return Report(failed=f"its workers died: {error}")
    except CancelledError:
        raise _lost(scheduler) from None


def _lost(scheduler: str | None) -> GrusError:
    return GrusError(
        f"scheduler = {scheduler!r}: lost; what is finished is in the store, start it again to go on"
    )


def _job(run: Run, store: Store, limits: dict) -> Job:
    folder, card = str(store.folder), run.card.to_dict()
    other = run.specimen_card and run.specimen_card.to_dict()
    source = run.card.source
    return Job(folder, run.kind, run.key, card, source, run.grain, specimen_card=other, **limits)


def _memory() -> int:
    """Memory of this machine [bytes]."""
    return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
