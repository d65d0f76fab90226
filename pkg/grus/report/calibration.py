"""The page of a calibration."""

from collections.abc import Sequence

from grus.calibrate.summary import rows
from grus.calibrate.words import measured, spread
from grus.report.content import Content, Grid, Picture

MOST_TRIALS = 500
"""Rows of the table of trials at most."""


def calibration_content(found: dict, pictures: Sequence[Picture]) -> Content:
    """found: what result.json holds."""
    parameters, targets, trials = found["parameters"], found["targets"], found["trials"]
    fitted = [
        (name, measured(one["value"], one["unit"]) + spread(one, found["confidence"]))
        for name, one in parameters.items()
    ]
    summary = [
        *fitted,
        (
            "misfit",
            f"{found['misfit']:.3g}, the sum over {len(targets)} targets of squared distances in tolerances",
        ),
        ("trials", f"{len(trials)}; the best is number {found['best_trial']}"),
        ("runs", f"{found['runs']}, of which {found['failed_runs']} failed"),
        ("a trial has", _a_trial(found)),
    ]
    missing = [f"{one['quantity']}: {one['missing']}" for one in targets.values() if one["missing"]]
    compared = [
        [one["quantity"] + at, wanted, measured(one["tolerance"], one["unit"]), model, off]
        for one in targets.values()
        for wanted, model, off, at in rows(one)
    ]
    header = ["trial", *parameters, "misfit"]
    units = [one["unit"] for one in parameters.values()]
    tried = [
        [str(one["number"]), *map(measured, one["values"], units), f"{one['misfit']:.4g}"]
        for one in trials[:MOST_TRIALS]
    ]
    if len(trials) > MOST_TRIALS:
        missing.append(f"of {len(trials)} trials the first {MOST_TRIALS} are shown")
    return Content(
        what="Calibration",
        name=found["name"],
        summary=summary,
        pictures=pictures,
        grids=[
            Grid(
                "Targets", ["target", "wanted", "tolerance", "model", "off by tolerances"], compared
            ),
            Grid("Trials", header, tried),
        ],
        card=found["card"],
        card_hash=found["card_hash"],
        versions=found["versions"],
        repeat=[
            f"grus calibrate {found['card_file']} {found['targets_file']} --trials {len(trials)} --out again"
        ],
        notes=missing,
    )


def _a_trial(found: dict) -> str:
    kinds = {one["kind"] for one in found["targets"].values()}
    parts = [f"{found['grains']} grains"] * ("crush" in kinds)
    if "oedometer" in kinds:
        parts.append(f"specimens of the seeds {', '.join(map(str, found['seeds']))}")
    return ", ".join(parts)
