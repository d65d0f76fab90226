"""Files that tell the outcome of an oedometer test."""

import json
import platform
from dataclasses import asdict
from pathlib import Path

import numpy as np
import pandas as pd

from grus.compression import BreakageOnset, YieldStress
from grus.files import replacing, write_text
from grus.oedometer.analysis import NO_BREAKAGE, NO_ONSET, Analysis
from grus.oedometer.figures import figures
from grus.oedometer.laboratory import laboratory
from grus.oedometer.program import program
from grus.oedometer.result import OedometerResult
from grus.oedometer.tables import curve_table, grading_table, stage_table
from grus.plotting import save
from grus.recording import write
from grus.scene.vtk import write_vtk
from grus.version import __version__


def write_report(
    result: OedometerResult, folder: str | Path, analysis: Analysis | None = None
) -> dict:
    """Writes result.json, recording.csv, tables, plots (PNG and SVG) and VTK files into `folder`; returns what result.json holds.

    analysis: that of `result` if it is at hand already.
    """
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    analysis = analysis or Analysis.of(result)
    tables = {
        "curve": curve_table(result),
        "stages": stage_table(result, analysis),
        "grading": grading_table(result, analysis),
    }
    for name, table in tables.items():
        _write_table(table, folder / f"{name}.csv")
    write(laboratory(result), folder / "recording.csv")
    plots = figures(result, analysis)
    for name, figure in plots.items():
        save(figure, folder / name)
    for end in result.stages:
        path = folder / "vtk" / f"stage-{end.number:03d}.vtp"
        path.parent.mkdir(exist_ok=True)
        write_vtk(path, result.prepared.specimen, end.state)
    found = numbers(result, analysis)
    files = [*(f"{name}.csv" for name in tables), *(f"{name}.png" for name in plots), "vtk/"]
    found["files"] = ["result.json", "recording.csv", *files]
    # Last, so that a result.json stands for a complete folder.
    text = json.dumps(found, indent=1, allow_nan=False)
    write_text(folder / "result.json", text + "\n")
    return found


def numbers(result: OedometerResult, analysis: Analysis) -> dict:
    """Everything that was found, as plain JSON; None where there is nothing to tell. SI units, marsal in per cent."""
    prepared, seated, last = result.prepared, result.seated, result.stages[-1]
    specimen = prepared.specimen
    error = result.energy_error
    at_ends = error[analysis.rows]
    return {
        "name": result.card.name,
        "grains": specimen.grain_count,
        "elements": specimen.element_count,
        "clumps": specimen.clump_count,
        "void_ratio": {
            "initial": seated.void_ratio,
            "final": last.void_ratio,
            "final_normalised": last.void_ratio / seated.void_ratio,
            "prepared": prepared.void_ratio,
            "prepared_by_elements": prepared.void_ratio_elements,
        },
        "bonds": {
            "initial": result.bonds,
            "broken": last.breaks,
            "broken_in_tension": last.tension_breaks,
            "broken_in_shear": last.shear_breaks,
            "broken_share": last.breaks / result.bonds if result.bonds else None,
        },
        "yield": _yield_numbers(analysis.yielding),
        "onset": _onset_numbers(analysis.onset),
        "K0": {"highest_stress": max(result.stages, key=lambda e: e.target).K0, "final": last.K0},
        "energy": {
            "error": float(at_ends[np.abs(at_ends).argmax()]),
            "error_within_stages": float(error[np.abs(error).argmax()]),
            "work": float(result.record["work"][-1]),
            "unit": "J",
        },
        "mass": {
            "initial": float(analysis.fragments[0].mass(result.card.element.density).sum()),
            "unit": "kg",
            "error": analysis.lost_mass(),
        },
        "laboratory": {
            "time": program(result.card)[-1].ends,
            "delayed_failures": int(result.rests["failures"][-1]) if len(result.rests) else 0,
            "unit": "s",
        },
        "inertial_number": float(result.record["inertial_number"].max()),
        "steps": last.steps,
        "stages": _stage_numbers(result, analysis),
        "card": result.card.to_dict(),
        "card_hash": result.card.content_hash(),
        "specimen_key": prepared.key,
        "versions": {
            "grus": __version__,
            "yade": _yade_version(),
            "python": platform.python_version(),
        },
    }


def _stage_numbers(result: OedometerResult, analysis: Analysis) -> list[dict]:
    return [
        {
            "number": end.number,
            "kind": end.kind,
            "target": end.target,
            "axial_stress": end.axial_stress,
            "side_stress": end.side_stress,
            "K0": end.K0,
            "height": end.height,
            "axial_strain": 1 - end.height / result.seated.height,
            "void_ratio": end.void_ratio,
            "void_ratio_normalised": end.void_ratio / result.seated.void_ratio,
            "tension_breaks": end.tension_breaks,
            "shear_breaks": end.shear_breaks,
            "fragments": part.count,
            "breakage": {"why": indices} if isinstance(indices, str) else asdict(indices),
            "energy_error": float(result.energy_error[row]),
            "steps": end.steps,
        }
        for end, part, indices, row in zip(
            result.stages, analysis.fragments, analysis.breakage, analysis.rows
        )
    ]


def _yield_numbers(found: YieldStress | str) -> dict:
    if isinstance(found, str):
        return {"stress": None, "interval": None, "why": found}
    return asdict(found) | {"unit": "Pa"}


def _onset_numbers(found: BreakageOnset | str) -> dict:
    if isinstance(found, str):
        return {"stress": None, "interval": None, "why": found}
    if found.stress is not None:
        return asdict(found) | {"unit": "Pa"}
    why = NO_ONSET if found.first_break is not None else NO_BREAKAGE
    return asdict(found) | {"unit": "Pa", "why": why}


def _write_table(table: pd.DataFrame, path: Path) -> None:
    with replacing(path) as partial:
        table.to_csv(partial, index=False, float_format="%.9g")


def _yade_version() -> str:
    from yade import config

    return config.version
