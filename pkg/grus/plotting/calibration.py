"""A calibration: targets against the model, and the path of the search."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from grus.plotting.labels import log_ticks, prefixed, significant
from grus.plotting.style import BLUE, GREY, VERMILION, style

WIDE, HIGH, ROW = 6.0, 3.4, 0.5
"""Width of a panel, and heights of a curve and of a row of single targets [inches]."""
COLUMNS = 2
KEY = 0.35
"""Room below the panels for a key that can never hide data [inches]."""
SHADE = 0.15


@style()
def targets_plot(result: dict) -> Figure:
    """Targets of one value in tolerances, and curves; result: what result.json holds."""
    curves = [one for one in result["targets"].values() if "stress" in one]
    single = [one for one in result["targets"].values() if "stress" not in one]
    heights = [1.3 + ROW * len(single)] * bool(single) + [HIGH] * len(curves)
    figure = Figure(figsize=(WIDE, 0.3 + sum(heights)), layout="constrained")
    panels = list(figure.subplots(len(heights), 1, squeeze=False, height_ratios=heights)[:, 0])
    if single:
        _draw_single(panels.pop(0), single)
    for axes, curve in zip(panels, curves):
        _draw_curve(axes, curve)
    figure.suptitle(f"{result['name']}: targets against the calibrated model", fontsize=10.5)
    return figure


def _draw_single(axes: Axes, targets: list[dict]) -> None:
    """A row a target: how far the model is off, with its own error, and both in words."""
    axes.axvspan(-1, 1, color=GREY, alpha=0.18, linewidth=0, label="tolerance")
    axes.axvline(0, color=GREY, linewidth=1)
    limit = 3.0
    labels = []
    for row, one in enumerate(targets):
        labels.append(f"{one['quantity']}\nwanted {_words(one['target'], one)}")
        if one["model"] is None:
            axes.text(0, row, "not shown by the model", ha="center", va="center", color=VERMILION)
            continue
        labels[-1] += f", model {_words(one['model'], one)}"
        off, error = one["off_by_tolerances"], (one["model_error"] or 0) / one["tolerance"]
        label = "model, with its standard error" if row == 0 else None
        axes.errorbar(off, row, xerr=error, fmt="o", color=BLUE, capsize=3, label=label)
        limit = max(limit, 1.1 * (abs(off) + error))
    axes.set(xlim=(-limit, limit), ylim=(len(targets) - 0.4, -0.6))
    axes.set_yticks(range(len(targets)), labels)
    axes.set_xlabel("Model less target [tolerances]")
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2)


def _draw_curve(axes: Axes, curve: dict) -> None:
    strain = curve["quantity"] == "axial strain"
    factor = 100.0 if strain else 1.0
    stress, wanted = 1e-3 * np.array(curve["stress"]), factor * np.array(curve["target"])
    tolerance = factor * curve["tolerance"]
    axes.errorbar(
        stress, wanted, yerr=tolerance, fmt="o", color=GREY, capsize=3, label="target and tolerance"
    )
    if curve["model"] is not None:
        axes.plot(stress, factor * np.array(curve["model"]), ".-", color=BLUE, label="model")
    axes.set_xscale("log")
    low, high = axes.get_xlim()
    ticks = log_ticks(low, high)
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.set_xticks([], minor=True)
    if strain:
        axes.invert_yaxis()
    axes.set_xlabel("Axial stress [kPa]")
    axes.set_ylabel("Axial strain from the first reading [%]" if strain else "Void ratio [–]")
    axes.legend()


@style()
def path_plot(result: dict) -> Figure:
    """Misfit of each trial in their order, and over each parameter."""
    trials, parameters = result["trials"], result["parameters"]
    misfit = np.array([one["misfit"] for one in trials])
    count = 1 + len(parameters)
    columns = min(COLUMNS, count)
    rows = -(-count // columns)
    height = 3.0 * rows + 0.3 + KEY
    figure = Figure(figsize=(3.6 * columns, height), layout="constrained")
    figure.get_layout_engine().set(rect=(0, KEY / height, 1, 1 - KEY / height))
    panels = figure.subplots(rows, columns, squeeze=False, sharey=True).ravel()
    for axes in panels[count:]:
        axes.set_axis_off()
    best = result["best_trial"] - 1
    panels[0].plot(
        1 + np.arange(len(trials)), misfit, "o", color=BLUE, markersize=3.5, label="trial"
    )
    steps = np.minimum.accumulate(misfit)
    panels[0].step(
        1 + np.arange(len(trials)),
        steps,
        where="post",
        color=GREY,
        linewidth=1,
        label="best so far",
    )
    panels[0].plot(1 + best, misfit[best], "*", color=VERMILION, markersize=10, label="best")
    panels[0].set_xlabel("Trial")
    panels[0].set_yscale("log")
    if any(one["interval"] is not None for one in parameters.values()):
        label = f"{result['confidence']:.0%} interval"
        panels[0].fill_between([], [], color=VERMILION, alpha=SHADE, linewidth=0, label=label)
    figure.legend(*panels[0].get_legend_handles_labels(), loc="lower center", ncols=4)
    for place, (axes, (name, one)) in enumerate(zip(panels[1:], parameters.items())):
        _draw_parameter(
            axes, name, one, np.array([t["values"][place] for t in trials]), misfit, best
        )
    for axes in panels[::columns]:
        axes.set_ylabel("Misfit [–]")
    figure.suptitle(f"{result['name']}: path of the search", fontsize=10.5)
    return figure


def _draw_parameter(
    axes: Axes, name: str, one: dict, values: np.ndarray, misfit: np.ndarray, best: int
) -> None:
    factor, unit = (1.0, "–") if one["unit"] == "1" else prefixed(one["bounds"][1], one["unit"])
    axes.plot(factor * values, misfit, "o", color=BLUE, markersize=3.5)
    axes.plot(factor * values[best], misfit[best], "*", color=VERMILION, markersize=10)
    if one["interval"] is not None:
        axes.axvspan(
            *(factor * end for end in one["interval"]), color=VERMILION, alpha=SHADE, linewidth=0
        )
    if one["logarithmic"]:
        axes.set_xscale("log")
        ticks = log_ticks(*(factor * end for end in one["bounds"]))
        axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
        axes.set_xticks([], minor=True)
    axes.set_xlabel(f"{name} [{unit}]")


def _words(value: float, one: dict) -> str:
    if one["unit"] == "1":
        return significant(value)
    factor, unit = prefixed(abs(value), one["unit"])
    return f"{significant(factor * value)} {unit}"
