"""Files that tell the outcome of a calibration."""

import json
import math
from pathlib import Path

import pandas as pd
import tomli_w

from grus.calibrate.calibration import Calibration
from grus.calibrate.intervals import CONFIDENCE
from grus.calibrate.misfit import off
from grus.calibrate.targets import OEDOMETER, Target
from grus.calibrate.trial import Trial
from grus.files import replacing, write_text
from grus.plotting import save
from grus.plotting.calibration import path_plot, targets_plot

CARD = "calibrated.toml"


def write_report(found: Calibration, folder: str | Path) -> dict:
    """Writes result.json, the calibrated card, trials.csv and plots into `folder`; returns what result.json holds."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    result = numbers(found)
    figures = {"targets": targets_plot(result), "path": path_plot(result)}
    for name, figure in figures.items():
        save(figure, folder / name)
    write_text(folder / CARD, card_text(found))
    with replacing(folder / "trials.csv") as partial:
        _table(found).to_csv(partial, index=False, float_format="%.9g")
    result["files"] = ["result.json", CARD, "trials.csv", *(f"{name}.png" for name in figures)]
    # Last, so that a result.json stands for a complete folder.
    write_text(folder / "result.json", json.dumps(result, indent=1, allow_nan=False) + "\n")
    return result


def numbers(found: Calibration) -> dict:
    """Everything that was found, as plain JSON in SI; None where there is nothing to tell."""
    best, targets = found.best, found.targets
    return {
        "what": "calibration",
        "name": found.card.name,
        "card_file": found.card.source,
        "targets_file": found.targets.source,
        "parameters": _parameters(found),
        "confidence": CONFIDENCE,
        "correlation": found.intervals and found.intervals.correlation,
        "targets": {one.name: _target(one, best) for one in targets.targets},
        "misfit": best.misfit,
        "best_trial": best.number,
        "trials": [
            {
                "number": one.number,
                "values": one.values,
                "misfit": one.misfit,
                "missing": _missing(one),
            }
            for one in found.trials
        ],
        "runs": found.runs,
        "failed_runs": found.failed,
        "grains": targets.grains,
        "specimens": targets.specimens,
        "seeds": _seeds(found),
        "card": found.calibrated.to_dict(),
        "card_hash": found.calibrated.content_hash(),
        "versions": found.versions,
    }


def card_text(found: Calibration) -> str:
    """The calibrated card as a file, values that were not fitted as the user wrote them."""
    card = found.calibrated
    written = card.written
    if card.mesh_path is not None:  # the file stands in another folder
        written["agglomerate"]["mesh"] = str(card.mesh_path)
    fitted = ", ".join(one.name for one in found.targets.parameters)
    text = tomli_w.dumps(written)
    return f"# {found.card.name} by `grus calibrate`, misfit {found.best.misfit:.3g}; fitted: {fitted}\n\n{text}"


def _parameters(found: Calibration) -> dict[str, dict]:
    told = {}
    for place, (parameter, value) in enumerate(zip(found.targets.parameters, found.best.values)):
        interval = found.intervals and [
            parameter.value(end[place]) for end in (found.intervals.low, found.intervals.high)
        ]
        told[parameter.name] = {
            "value": value,
            "interval": interval,
            "fixed_by_targets": found.intervals and found.intervals.fixed[place],
            "bounds": [parameter.low, parameter.high],
            "unit": parameter.unit or "1",
            "logarithmic": parameter.logarithmic,
            "tied": parameter.tied,
        }
    return told


def _target(target: Target, best: Trial) -> dict:
    """A target against the model; lists for a curve."""
    answer, distance = best.answers[target.name], off(target, best.answers[target.name])
    told = {
        "kind": target.kind,
        "quantity": target.quantity,
        "unit": target.unit,
        "tolerance": target.tolerance,
    }
    columns = {
        "target": target.values,
        "model": answer.values,
        "model_error": [None if math.isnan(e) else e for e in answer.error],
        "off_by_tolerances": () if distance is None else distance.tolist(),
    }
    if target.stress:
        told |= {"stress": target.stress} | {name: list(v) or None for name, v in columns.items()}
    else:
        told |= {name: v[0] if v else None for name, v in columns.items()}
    return told | {"missing": answer.missing}


def _missing(trial: Trial) -> dict[str, str]:
    return {name: one.missing for name, one in trial.answers.items() if one.missing is not None}


def _seeds(found: Calibration) -> list[int]:
    count = found.targets.specimens if found.targets.of(OEDOMETER) else 1
    return [found.card.seed + number for number in range(count)]


def _table(found: Calibration) -> pd.DataFrame:
    """A row a trial: parameters in SI, misfit, what the model shows of targets of one value."""
    rows = []
    for one in found.trials:
        row = {"trial": one.number}
        for parameter, value in zip(found.targets.parameters, one.values):
            row[f"{parameter.name} [{parameter.unit or '1'}]"] = value
        row["misfit"] = one.misfit
        for target in found.targets.targets:
            answer = one.answers[target.name]
            if not target.stress:
                row[f"{target.name} [{target.unit}]"] = answer.values[0] if answer.values else None
        rows.append(row)
    return pd.DataFrame(rows)
