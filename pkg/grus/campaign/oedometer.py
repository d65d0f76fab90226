"""An oedometer test of a campaign."""

import math

from grus.campaign.outcome import Findings
from grus.campaign.run import Run
from grus.campaign.store import Store
from grus.oedometer import Analysis, OedometerResult, laboratory, oedometer
from grus.oedometer.report import numbers

TEXTS = ("card", "versions")


def simulate(run: Run, store: Store, restart: bool) -> Findings:
    """Laboratory record, and all numbers of the test's report."""
    result = _result(run, store, restart)
    found = numbers(result, Analysis.of(result))
    return Findings(laboratory(result), flat({n: v for n, v in found.items() if n not in TEXTS}))


def recording(run: Run, store: Store, restart: bool) -> Findings:
    """The same record, and only the numbers that need no analysis of grading and yield, which takes a second."""
    result = _result(run, store, restart)
    last = result.stages[-1]
    figures = {
        "bonds.initial": float(result.bonds),
        "bonds.broken": float(last.breaks),
        "void_ratio.initial": result.seated.void_ratio,
        "void_ratio.final": last.void_ratio,
        "K0.final": last.K0,
        "steps": float(last.steps),
    }
    return Findings(laboratory(result), figures)


def _result(run: Run, store: Store, restart: bool) -> OedometerResult:
    """The test, which goes on where an earlier process was cut off."""
    return oedometer(
        run.card,
        store.work(run.key),
        specimens=store.specimens,
        restart=restart,
        specimen_card=run.specimen_card,
    )


def flat(tree: dict | list, parent: str = "") -> dict[str, float]:
    """Numbers of nested tables and lists by dotted names; what is no finite number is left out."""
    items = tree.items() if isinstance(tree, dict) else enumerate(tree)
    result: dict[str, float] = {}
    for name, value in items:
        if isinstance(value, (dict, list, tuple)):
            result |= flat(value, f"{parent}{name}.")
        elif isinstance(value, (int, float)) and math.isfinite(value):
            result[f"{parent}{name}"] = float(value)
    return result
