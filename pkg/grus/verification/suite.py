"""All cases of the verification, run by a worker of their own."""

from collections.abc import Callable, Iterator
from pathlib import Path

from distributed import as_completed

from grus.campaign import workers
from grus.verification.breaking import breaking_rows
from grus.verification.contact_options import contact_options_rows
from grus.verification.elastic import elastic_rows
from grus.verification.energy import energy_rows
from grus.verification.invariance import invariance_rows
from grus.verification.other_laws import other_laws_rows
from grus.verification.other_laws_block import Curves, block_curves, block_rows
from grus.verification.rotation_law import rotation_law_rows
from grus.verification.row import Row
from grus.verification.time_step import time_step_rows
from grus.verification.verification import Verification

Progress = Callable[[int, int], None]
CASES: tuple[Callable[[], Iterator[Row] | Curves], ...] = (
    elastic_rows,
    breaking_rows,
    invariance_rows,
    other_laws_rows,
    rotation_law_rows,
    contact_options_rows,
    block_curves,
    time_step_rows,
    energy_rows,
)


def verify(folder: str | Path | None = None, progress: Progress | None = None) -> Verification:
    """Runs every case; with a `folder` the table and figures are written there.

    The cases run one after the other in a single worker of Dask with one thread, so the scene of the caller stays as
    it is and the numbers do not depend on the number of threads. `progress(done, of)` is called after each group of
    cases.
    """
    progress = progress or (lambda done, of: None)
    progress(0, len(CASES))
    found: dict[int, list[Row] | Curves] = {}
    with workers(1, ahead=False) as client:
        runs = {
            client.submit(_run, case, pure=False, priority=-index): index
            for index, case in enumerate(CASES)
        }
        for run in as_completed(runs):
            found[runs[run]] = run.result()
            progress(len(found), len(CASES))
    rows: list[Row] = []
    curves: Curves = {}
    for index in range(len(CASES)):
        result = found[index]
        if isinstance(result, dict):
            curves = result
            result = block_rows(curves)
        rows.extend(result)
    verification = Verification(tuple(rows), curves)
    if folder is not None:
        verification.write(folder)
    return verification


def _run(case: Callable[[], Iterator[Row] | Curves]) -> list[Row] | Curves:
    found = case()
    return found if isinstance(found, dict) else list(found)
