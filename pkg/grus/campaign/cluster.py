"""Dask's workers: processes on this machine, or those of a running scheduler."""

import logging
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import dask
from distributed import Client, LocalCluster

from grus.campaign.processes import start_ahead
from grus.campaign.store import Tell, quiet
from grus.campaign.surroundings import ignored_interrupts, surroundings
from grus.errors import GrusError, one_line

CONNECT = 20.0
"""Seconds after which a scheduler counts as not to be reached."""
WORKERS = "/info/main/workers.html"
"""Page of Dask's server that needs none of the further libraries of its dashboard."""


@contextmanager
def workers(
    jobs: int, scheduler: str | None = None, tell: Tell = quiet, ahead: bool = True
) -> Iterator[Client]:
    """Client of `jobs` worker processes of this machine, or of the scheduler at this address or with this scheduler file.

    ahead: whether workers of this machine have YADE loaded for their first simulation before it comes.
    Raises GrusError when there is no scheduler.
    """
    if scheduler is None:
        with _local(jobs) as cluster, Client(cluster) as client:
            if ahead:
                client.run(start_ahead)
            tell(f"Dask's workers: {_page(client)}")
            yield client
        return
    where = {"scheduler_file" if Path(scheduler).is_file() else "address": scheduler}
    try:
        client = Client(**where, timeout=CONNECT)
    except (OSError, ValueError, KeyError) as error:
        raise GrusError(
            f"scheduler = {scheduler!r}: {one_line(error)}; allowed: the address of one that runs, as tcp://host:8786, "
            "or its scheduler file"
        ) from None
    with client:
        tell(f"Dask's workers: {_page(client)}")
        yield client


@contextmanager
def _local(jobs: int) -> Iterator[LocalCluster]:
    settings = {"distributed.worker.multiprocessing-method": "spawn"}
    with tempfile.TemporaryDirectory() as folder, dask.config.set(settings), surroundings():
        with ignored_interrupts():
            cluster = LocalCluster(
                n_workers=jobs,
                threads_per_worker=1,
                memory_limit=None,  # that of the simulations is their own
                dashboard_address="127.0.0.1:0",
                local_directory=folder,
                silence_logs=logging.CRITICAL,
            )
        try:
            yield cluster
        finally:
            # On a machine that is very busy a worker may not end in the time that Dask allows; it is killed then, and
            # what it had to tell has been told.
            with suppress(TimeoutError):
                cluster.close()


def _page(client: Client) -> str:
    return client.dashboard_link.removesuffix("/status") + WORKERS
