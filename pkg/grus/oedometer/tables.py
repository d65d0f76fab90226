"""Tables of an oedometer test, with units in their headers."""

import numpy as np
import pandas as pd

from grus.grading import Grading
from grus.oedometer.analysis import Analysis
from grus.oedometer.result import OedometerResult

SCALED = {"Pa": (1e-3, "kPa"), "m": (1e3, "mm")}
"""Units that tables give in the manner of a laboratory."""
INDICES = {"hardin": "1", "einav": "1", "marsal": "%", "lee_farhoomand": "1", "new_surface": "1/m"}


def curve_table(result: OedometerResult) -> pd.DataFrame:
    """A row a reading; strain, e0 and gradings refer to the end of the seating."""
    r, seated = result.record, result.seated
    axial = result.stress
    height = r["height"]
    columns = {
        "time": ("s", r["time"]),
        "step": ("1", r["iter"]),
        "stage": ("1", r["stage"]),
        "axial_strain": ("1", 1 - height / seated.height),
        "axial_stress": ("Pa", axial),
        "top_stress": ("Pa", r["top_stress"]),
        "bottom_stress": ("Pa", r["bottom_stress"]),
        "side_stress": ("Pa", r["side_stress"]),
        "K0": ("1", np.divide(r["side_stress"], axial, out=np.zeros_like(axial), where=axial > 0)),
        "void_ratio": ("1", result.void_ratio),
        "void_ratio_normalised": ("1", result.void_ratio / seated.void_ratio),
        "height": ("m", height),
        "bonds_broken": ("1", result.broken),
    }
    named = {"iter", "time", "stage", "height", "top_stress", "bottom_stress", "side_stress"}
    others = {n: (r.units[n], values) for n, values in r.channels.items() if n not in named}
    return _frame(columns | others | {"energy_error": ("1", result.energy_error)})


def stage_table(result: OedometerResult, analysis: Analysis) -> pd.DataFrame:
    """A row a stage."""
    ends, seated = result.stages, result.seated
    broken = np.array([end.breaks for end in ends])
    columns = {
        "stage": ("1", [end.number for end in ends]),
        "kind": (None, [end.kind for end in ends]),
        "target": ("Pa", np.array([end.target for end in ends])),
        "axial_stress": ("Pa", np.array([end.axial_stress for end in ends])),
        "side_stress": ("Pa", np.array([end.side_stress for end in ends])),
        "K0": ("1", [end.K0 for end in ends]),
        "height": ("m", np.array([end.height for end in ends])),
        "axial_strain": ("1", [1 - end.height / seated.height for end in ends]),
        "void_ratio": ("1", [end.void_ratio for end in ends]),
        "void_ratio_normalised": ("1", [end.void_ratio / seated.void_ratio for end in ends]),
        "bonds_broken": ("1", broken),
        "bonds_broken_in_stage": ("1", np.diff(broken, prepend=0)),
        "tension_breaks": ("1", [end.tension_breaks for end in ends]),
        "shear_breaks": ("1", [end.shear_breaks for end in ends]),
        "fragments": ("1", [part.count for part in analysis.fragments]),
        "d50": ("m", np.array([_median(one) for one in analysis.gradings])),
    }
    for name, unit in INDICES.items():
        columns[name] = (unit, [getattr(one, name, np.nan) for one in analysis.breakage])
    columns["energy_error"] = ("1", result.energy_error[analysis.rows])
    columns["steps"] = ("1", [end.steps for end in ends])
    return _frame(columns)


def grading_table(result: OedometerResult, analysis: Analysis) -> pd.DataFrame:
    """A row a sieve, a column a stage: per cent passing after it."""
    columns = {"sieve": ("m", analysis.gradings[0].sizes)}
    for end, grading in zip(result.stages, analysis.gradings):
        columns[f"stage {end.number} {end.name}"] = ("%", grading.passing)
    return _frame(columns)


def _median(grading: Grading) -> float:
    return grading.d50 if grading.passing[0] <= 50 else np.nan


def _frame(columns: dict) -> pd.DataFrame:
    table = {}
    for name, (unit, values) in columns.items():
        factor, shown = SCALED.get(unit, (None, unit))
        header = name if unit is None else f"{name} [{shown}]"
        table[header] = values if factor is None else factor * values
    return pd.DataFrame(table)
