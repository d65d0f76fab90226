"""Oedometer tests at 0.01 m/s and at adaptive speeds: void ratios, breakage, steps."""

import json
from pathlib import Path

import numpy as np
from grus.files import write_text
from grus.plotting import draw_key, new_figure, save, style
from grus.plotting.style import PALETTE
from matplotlib.figure import Figure
from tests import FAST, FIGURES, SEEDS, tested

SETTINGS = {
    "constant": {},
    "adaptive": {"fastSpeed": FAST},
    "kinetic": {"fastSpeed": FAST, "kineticLimit": 1e-2},
    "loose": {
        "fastSpeed": 0.3,
        "inertialLimit": 1e-2,
        "kineticLimit": 1e-1,
        "gradientLimit": 0.1,
    },
}

WIDEST = 15
"""Change of e0 - e that the plot shows [%]; one test of the loose limits collapses far beyond."""


def main() -> None:
    rows = {name: [tested(name, seed, **c) for seed in SEEDS] for name, c in SETTINGS.items()}
    compression, broken, steps, waiting = (
        {name: column(tests) for name, tests in rows.items()}
        for column in (_compression, _column("broken"), _column("steps"), _column("waiting"))
    )
    numbers = {"stages": [row["stage"] for row in rows["constant"][0][1:]], "settings": SETTINGS}
    for name in SETTINGS:
        change = compression[name] / compression["constant"] - 1
        numbers[name] = {
            "compression": compression[name].tolist(),
            "compression_change": change.tolist(),
            "broken": broken[name].tolist(),
            "mean_broken": broken[name].mean(axis=0).tolist(),
            "deviation_of_broken": broken[name].std(axis=0, ddof=1).tolist(),
            "steps": steps[name].tolist(),
            "waiting": waiting[name].tolist(),
            "steps_saved": (steps["constant"].sum(axis=1) / steps[name].sum(axis=1)).tolist(),
            "most_to_save": (steps["constant"].sum(axis=1) / waiting[name].sum(axis=1)).tolist(),
        }
    write_text(Path(__file__).parent / "numbers.json", json.dumps(numbers, indent=1) + "\n")
    save(_plot(compression, broken, steps, waiting), FIGURES / "speeds")
    for name, found in numbers.items():
        print(name, json.dumps(found))


def _compression(tests: list[list[dict]]) -> np.ndarray:
    """e0 - e (seeds, stages) since the seating."""
    return np.array(
        [[test[0]["void_ratio"] - row["void_ratio"] for row in test[1:]] for test in tests]
    )


def _column(name: str):
    return lambda tests: np.array([[row[name] for row in test[1:]] for test in tests])


@style()
def _plot(compression: dict, broken: dict, steps: dict, waiting: dict) -> Figure:
    """By stage: change of e0 - e and bonds broken of each test; below the steps of each setting."""
    figure, axes = new_figure((8.4, 3.4), key_rows=len(SETTINGS) + 1)
    axes.remove()
    left, middle, right = figure.subplots(1, 3)
    stresses = [100, 200, 300, 400]
    for colour, (name, found) in zip(PALETTE, compression.items()):
        change = 100 * (found / compression["constant"] - 1)
        left.plot(stresses, change[:, :-1].T, ".-", color=colour)
        middle.plot(stresses, broken[name][:, :-1].T, ".-", color=colour)
    for axes, label in ((left, "Change of $e_0 - e$ [%]"), (middle, "Bonds broken")):
        axes.set_xlabel("Axial stress [kPa]")
        axes.set_ylabel(label)
    left.axhspan(-1, 1, color="#DDDDDD")
    left.set_ylim(-WIDEST, WIDEST)
    middle.set_ylim(0, None)
    places = np.arange(len(steps))
    total = np.array([found.sum(axis=1).mean() for found in steps.values()])
    rest = np.array([found.sum(axis=1).mean() for found in waiting.values()])
    right.bar(places, 1e-3 * total, color=PALETTE[: len(steps)])
    right.bar(places, 1e-3 * rest, color="none", edgecolor="black", hatch="///")
    right.set_xticks(places, list(steps), rotation=30)
    right.set_ylabel("Steps of a test [thousand]")
    handles = [left.plot([], [], color=colour)[0] for colour, _ in zip(PALETTE, steps)]
    hatched = right.bar([0], [0], color="none", edgecolor="black", hatch="///")
    draw_key(figure, [*handles, hatched], [*steps, "hatched: waiting for rest at the target"])
    return figure


if __name__ == "__main__":
    main()
