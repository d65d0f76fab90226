"""Figures of an oedometer test."""

import numpy as np
from matplotlib.figure import Figure

from grus.oedometer.analysis import Analysis
from grus.oedometer.evenly import evenly
from grus.oedometer.picture import crushed_picture, force_chain_picture
from grus.oedometer.result import OedometerResult
from grus.plotting.compression import breakage_plot, compression_plot
from grus.plotting.energy import energy_plot
from grus.plotting.grading import grading_plot
from grus.plotting.lateral import lateral_plot

GRADINGS = 8
"""Gradings in one plot."""


def figures(result: OedometerResult, analysis: Analysis) -> dict[str, Figure]:
    """By the names of their files."""
    name, stress = result.card.name, result.stress
    found = {"yield": analysis.yielding, "onset": analysis.onset}
    marks = {what: {} if isinstance(one, str) else {name: one} for what, one in found.items()}
    highest = max(result.stages, key=lambda end: end.target)
    last = result.stages[-1]
    plots = {
        "compression": compression_plot(
            {name: (stress, result.void_ratio)},
            marks["yield"],
            reference=result.seated.void_ratio,
        )
    }
    ratio = result.record["side_stress"] / stress.clip(min=1)
    return plots | {
        "breakage": breakage_plot({name: (stress, result.broken)}, marks["onset"]),
        "grading": grading_plot(_gradings(result, analysis), title=name),
        "energy": _energy_plot(result, analysis),
        "K0": lateral_plot(stress, ratio, _apart(result), analysis.rows, title=name),
        "force-chains": force_chain_picture(
            result, [highest, last] if highest is not last else [last]
        ),
        "crushed": crushed_picture(result, last),
    }


def _gradings(result: OedometerResult, analysis: Analysis) -> dict:
    """By stage; a stage that is repeated has its number in the name."""
    shown = evenly(len(result.stages), GRADINGS)
    return {f"{i}: {result.stages[i].name}": analysis.gradings[i] for i in shown}


def _apart(result: OedometerResult) -> np.ndarray:
    """Mask (n,) of the readings in stages that do not load beyond all before."""
    highest, apart = 0.0, []
    for end in result.stages:
        apart.append(end.target <= highest)
        highest = max(highest, end.target)
    return np.array(apart)[result.record["stage"]]


def _energy_plot(result: OedometerResult, analysis: Analysis) -> Figure:
    r = result.record
    steps, stage = r["iter"], r["stage"]
    ends = steps[analysis.rows]
    begins = [0, *ends[:-1]]
    progress = stage + (steps - [begins[s] for s in stage]) / [ends[s] - begins[s] for s in stage]
    stored = r["elastic_energy"]
    parts = {
        "elastic energy, change since the start": stored - stored[0],
        "kinetic energy": r["kinetic_energy"],
        "released by broken bonds": r["released_energy"],
        "friction": r["sliding_work"],
        "damping": r["damped_energy"],
    }
    names = [end.name for end in result.stages]
    return energy_plot(
        progress, names, r["work"], parts, result.energy_error, title=result.card.name
    )
