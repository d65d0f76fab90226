"""Work in other processes that load YADE for themselves, each with one thread."""

import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from contextlib import contextmanager
from multiprocessing import active_children, get_context


def run_in_processes(
    function: Callable,
    calls: Sequence[tuple],
    count: int,
    done: Callable[[int, object], None],
) -> None:
    """Runs `function(*call)` for each of `calls`, `count` at a time; `done(index, result)` is called as each ends.

    function: of a module of Grus, since the processes know no other. What is raised, by the function, by `done` or by
    Ctrl-C, ends the processes at once and is passed on.
    """
    others = set(active_children())
    with surroundings(), ProcessPoolExecutor(count, mp_context=get_context("spawn")) as pool:
        try:
            with ignored_interrupts():
                runs = {pool.submit(function, *call): index for index, call in enumerate(calls)}
            for run in as_completed(runs):
                done(runs[run], run.result())
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            for process in set(active_children()) - others:
                process.terminate()
            raise


@contextmanager
def surroundings() -> Iterator[None]:
    """What a new process finds: one thread, and no main file."""
    # YADE keeps one scene per process and threads of its own: a fork of a process that has loaded it may hang. OpenMP
    # reads its variable while the new process loads it, so it must be in the environment before.
    before = os.environ.get("OMP_NUM_THREADS")
    os.environ["OMP_NUM_THREADS"] = "1"
    # A new process would run the main file again, which inside `yade` is YADE's program itself.
    main = vars(sys.modules["__main__"])
    file = main.pop("__file__", None)
    try:
        yield
    finally:
        if file is not None:
            main["__file__"] = file
        if before is None:
            del os.environ["OMP_NUM_THREADS"]
        else:
            os.environ["OMP_NUM_THREADS"] = before


@contextmanager
def ignored_interrupts() -> Iterator[None]:
    """Processes that are started meanwhile never see Ctrl-C: the one that started them ends them."""
    if threading.current_thread() is not threading.main_thread():
        yield  # only the main thread may set handlers
        return
    handler = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, handler)
