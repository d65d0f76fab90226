"""Other processes that load YADE for themselves, each with one thread."""

import os
import sys
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing import get_context


@contextmanager
def one_thread_processes(count: int) -> Iterator[ProcessPoolExecutor]:
    """Gives a pool of `count` processes; when the block is left by an exception, waiting work is dropped."""
    # YADE keeps one scene per process and threads of its own: a fork of a process that has loaded it may hang.
    # OpenMP reads its variable while the new process loads it, so it must be in the environment before.
    before = os.environ.get("OMP_NUM_THREADS")
    os.environ["OMP_NUM_THREADS"] = "1"
    # A new process would run the main file again, which inside `yade` is YADE's program itself. What it is given to do
    # comes from Grus's modules, so it needs no main file.
    main = vars(sys.modules["__main__"])
    file = main.pop("__file__", None)
    try:
        with ProcessPoolExecutor(count, mp_context=get_context("spawn")) as pool:
            try:
                yield pool
            except BaseException:
                pool.shutdown(wait=False, cancel_futures=True)
                raise
    finally:
        if file is not None:
            main["__file__"] = file
        if before is None:
            del os.environ["OMP_NUM_THREADS"]
        else:
            os.environ["OMP_NUM_THREADS"] = before
