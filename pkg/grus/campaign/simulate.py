"""One simulation of a campaign, in the current process, which does nothing else."""

import errno
import resource
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from importlib import import_module

from grus.campaign.exit_codes import DONE, REFUSED, UNWRITABLE
from grus.campaign.job import SPECIMEN, Job
from grus.campaign.outcome import Findings, Outcome
from grus.campaign.store import Store
from grus.campaign.versions import versions
from grus.errors import GrusError, one_line
from grus.preparation import prepare

PROCEDURES = {
    "crush": ("grus.campaign.crushing", "simulate"),
    "oedometer": ("grus.campaign.oedometer", "simulate"),
    "recording": ("grus.campaign.oedometer", "recording"),
}
"""Kind of a run -> module and function."""
FULL = {errno.ENOSPC, errno.EDQUOT, errno.EROFS, errno.EACCES}


def procedure(kind: str) -> Callable[..., Findings]:
    """What simulates runs of a kind: (run, store, restart) -> Findings. Its module is loaded at first use."""
    module, name = PROCEDURES[kind]
    return getattr(import_module(module), name)


def simulate(job: Job) -> int:
    """Does the job in this process; its outcome goes into the store. Returns one of the exit codes."""
    if job.memory_limit is not None:
        resource.setrlimit(resource.RLIMIT_DATA, (job.memory_limit, job.memory_limit))
    try:
        _prepare(job) if job.kind == SPECIMEN else _test(job)
    except GrusError as error:
        print(one_line(error), file=sys.stderr)
        return REFUSED
    except OSError as error:
        if error.errno not in FULL:
            raise
        print(f"{error.filename or job.store}: {error.strerror}", file=sys.stderr)
        return UNWRITABLE
    return DONE


def _prepare(job: Job) -> None:
    store = Store(job.store)
    prepare(job.made_card(), store.specimens)
    store.seal_specimen(job.key)


def _test(job: Job) -> None:
    store, run = Store(job.store), job.run()
    if run.key != job.key:
        raise GrusError(f"{job.source}: another version of Grus, or another mesh, on this machine")
    restart = job.attempt > 0
    resumed = store.work(job.key).exists() and not restart
    outcome = Outcome(**job.identity, versions=versions())
    start = time.monotonic()
    try:
        outcome = replace(outcome, **vars(procedure(job.kind)(run, store, restart)))
    except GrusError as error:
        if resumed:  # what an earlier process has left may be to blame, and not the card
            store.forget_work(job.key)
            return _test(job)
        outcome = replace(outcome, failed=one_line(error), refused=True)
    store.save(replace(outcome, seconds=time.monotonic() - start))
    store.forget_work(job.key)
