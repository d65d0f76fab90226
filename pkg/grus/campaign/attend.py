"""What a Dask worker does with a job: it has a process simulate, watches it, and tries once more when it breaks."""

import errno
import os
import signal
import tempfile
import time
from dataclasses import dataclass, replace
from pathlib import Path

from grus.campaign.exit_codes import DONE, REFUSED, UNWRITABLE
from grus.campaign.job import Job
from grus.campaign.outcome import Outcome
from grus.campaign.processes import simulate
from grus.campaign.store import Store

ATTEMPTS = 2
LOG = 100_000
"""Bytes of the end of a log that are kept."""


@dataclass(frozen=True)
class Report:
    """How a job went, for the one who gave it. begun: False when its time was over before.

    failed: what went wrong, None when nothing did; final: whether it would again. lines: to be told.
    """

    begun: bool = True
    failed: str | None = None
    final: bool = False
    log: str = ""
    lines: tuple[str, ...] = ()


def attend_specimen(job: Job) -> Report:
    """Sees to it that the specimen is in the store, prepared by one process at a time."""
    store, lines = Store(job.store), []
    with store.lock(f"specimen-{job.key}"):
        if store.check_specimen(job.key, lines.append):
            return Report(lines=tuple(lines))
        return replace(_attempts(job), lines=tuple(lines))


def attend_test(job: Job, specimen: Report | None = None) -> Report:
    """Sees to it that the outcome of the run is in the store, that of a failure too.

    specimen: the report on its specimen. Raises OSError when the store cannot be written.
    """
    store = Store(job.store)
    with store.lock(job.key):
        found = store.find(job.key)
        if found is not None and found.final:  # another campaign was quicker
            return Report()
        report = specimen
        if specimen is None or (specimen.begun and specimen.failed is None):
            report = _attempts(job)
        if report.failed is not None:
            store.save(failure(job, report))
        return replace(report, lines=())


def failure(job: Job, report: Report) -> Outcome:
    """The outcome of a run that failed."""
    return Outcome(**job.identity, failed=report.failed, refused=report.final, log=report.log)


def _attempts(job: Job) -> Report:
    report = Report(begun=False)
    for attempt in range(ATTEMPTS):
        if job.until is not None and time.time() > job.until:
            return report
        report, again = _attempt(replace(job, attempt=attempt))
        if not again:
            return report
    return replace(report, failed=f"{report.failed}; the second attempt too")


def _attempt(job: Job) -> tuple[Report, bool]:
    """How one process went, and whether another should try."""
    with tempfile.NamedTemporaryFile() as log:
        code = simulate(job, Path(log.name))
        text = _end(log)
    last = (text.strip().splitlines() or [""])[-1]
    if code == DONE:
        return Report(), False
    if code == REFUSED:
        return Report(failed=last, final=True, log=text), False
    if code == UNWRITABLE:
        raise OSError(errno.ENOSPC, last)
    if code is None:
        # A test that was saved on its way goes on from there in the next campaign.
        return Report(failed=f"not over within {job.time_limit:g} s", log=text), False
    how = f"ended by {signal.Signals(-code).name}" if code < 0 else f"ended with exit code {code}"
    return Report(failed=f"{how}: {last}" if last else how, log=text), True


def _end(log) -> str:
    size = log.seek(0, os.SEEK_END)
    log.seek(max(0, size - LOG))
    return log.read().decode(errors="replace")
