"""A process that has loaded YADE and forks one for every job: `python3 -m grus.campaign.warm`.

Loading takes seconds, a fork none. A job is a line on standard input, Job and path of its log; the answers, a line each,
are the id of the process that simulates and its exit code, negative when a signal ended it. It ends with its input.
"""

import json
import os
import signal
import sys
import threading

from grus.campaign.job import SPECIMEN, Job
from grus.campaign.simulate import procedure, simulate


def main() -> None:
    # As long as no simulation has run here, YADE has no threads that a fork would lose.
    while line := _line():
        keys, log = json.loads(line)
        job = Job(**keys)
        if job.kind != SPECIMEN:
            procedure(job.kind)  # loaded here once, and not in every fork
        process = os.fork()
        if process == 0:
            _simulate(job, log)
        _answer(process)
        _answer(os.waitstatus_to_exitcode(os.waitpid(process, 0)[1]))


def _simulate(job: Job, log: str) -> None:
    """Never returns: what the parent was about to do is not for its child."""
    code = 1
    try:
        os.dup2(os.open(log, os.O_WRONLY | os.O_APPEND), 1)
        os.dup2(1, 2)
        threading.Thread(target=_die_with_worker, daemon=True).start()
        code = simulate(job)
    except BaseException:
        sys.excepthook(*sys.exc_info())
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code)


def _die_with_worker() -> None:
    # While a job is done nothing is written to standard input: it ends when the worker that holds its other end dies.
    while os.read(0, 1):
        pass
    os.kill(os.getpid(), signal.SIGKILL)


def _line() -> bytes:
    # Not through sys.stdin, whose lock a forked process would inherit.
    text = b""
    while not text.endswith(b"\n"):
        part = os.read(0, 65536)
        if not part:
            return b""
        text += part
    return text


def _answer(number: int) -> None:
    os.write(1, f"{number}\n".encode())


if __name__ == "__main__":
    main()
