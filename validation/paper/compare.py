"""The paper's results beside those of the tests that are under results/validation-paper: tables and plots."""

import json
from pathlib import Path

import numpy as np
import pandas as pd
from grus.files import write_text
from grus.plotting import draw_key, new_figure, save, style
from grus.plotting.style import BLACK, PALETTE
from matplotlib.figure import Figure
from tests import ALL, CHOSEN, FIGURES, GRAINS, SEEDS, SPEEDS, folder

SETTINGS = (("adaptive", SPEEDS[0], True), *((f"{v:g} m/s", v, False) for v in SPEEDS))
PAPER = "paper: at 1 MPa"


def found(grains: int, seed: int, speed: float, strength: float, adaptive: bool) -> dict | None:
    """Figures of one test, with its curve under "curve"; None when it has not been run to its end."""
    home = folder(grains, seed, speed, strength, adaptive)
    if not (home / "result.json").exists():
        return None
    result = json.loads((home / "result.json").read_text())
    curve = pd.read_csv(home / "curve.csv")
    curve["bonds_lost [%]"] = 100 * curve["bonds_broken [1]"] / result["bonds"]["initial"]
    stages = pd.read_csv(home / "stages.csv")
    loads = stages[stages["kind"] == "load"]
    last = loads.iloc[-1]
    strain = loads["axial_strain [1]"].diff().fillna(loads["axial_strain [1]"].iloc[0])
    by_target = dict(zip(loads["target [kPa]"], strain))
    gone = stages["bonds_broken [1]"].iloc[-1] - last["bonds_broken [1]"]
    return {
        "initial void ratio": result["void_ratio"]["initial"],
        "e/e0 at 1 MPa": last["void_ratio_normalised [1]"],
        "bonds lost at 1 MPa [%]": 100 * last["bonds_broken [1]"] / result["bonds"]["initial"],
        "first bond broken [kPa]": _kilopascal(result["onset"], "first_break"),
        "onset of sustained breakage [kPa]": _kilopascal(result["onset"], "stress"),
        "yield [kPa]": _kilopascal(result["yield"], "stress"),
        "broken in unloading": int(gone),
        "recovered of the strain": 1
        - stages["axial_strain [1]"].iloc[-1] / last["axial_strain [1]"],
        "strain of the stage to 100 kPa": by_target[100],
        "strain of the stage to 500 kPa": by_target[500],
        "K0 at 1 MPa": last["K0 [1]"],
        "energy error [%]": 100 * abs(result["energy"]["error"]),
        "steps": result["steps"],
        "curve": curve,
    }


def _kilopascal(table: dict, key: str) -> float:
    value = table.get(key)
    return float("nan") if value is None else value / 1e3


def main() -> None:
    tests = {
        name: [one for seed in SEEDS if (one := found(GRAINS, seed, speed, CHOSEN, adaptive))]
        for name, speed, adaptive in SETTINGS
    }
    tests = {name: rows for name, rows in tests.items() if rows}
    full = found(ALL, 1, SPEEDS[0], CHOSEN, True)
    numbers = {}
    for name, rows in [*tests.items(), *([(f"{ALL} grains, adaptive", [full])] if full else [])]:
        plain = [{key: value for key, value in row.items() if key != "curve"} for row in rows]
        table = pd.DataFrame(plain).astype(float)
        numbers[name] = {
            key: {"values": column.tolist(), "mean": column.mean(), "deviation": column.std()}
            for key, column in table.items()
        }
    write_text(Path(__file__).parent / "numbers.json", json.dumps(numbers, indent=1) + "\n")
    save(_plot(tests, full), FIGURES / "tests")
    print(_table(numbers))


def _table(numbers: dict) -> str:
    """Mean and standard deviation over the seeds, in Markdown."""
    lines = ["| result | " + " | ".join(numbers) + " |", "|---" * (len(numbers) + 1) + "|"]
    for key in next(iter(numbers.values())):
        cells = []
        for column in numbers.values():
            mean, deviation = column[key]["mean"], column[key]["deviation"]
            known = [value for value in column[key]["values"] if np.isfinite(value)]
            text = "none" if not known else f"{mean:.4g}"
            if len(known) > 1:
                text += f" ± {deviation:.2g}"
            if 0 < len(known) < len(column[key]["values"]):
                text += f" ({len(known)} of {len(column[key]['values'])})"
            cells.append(text)
        lines.append(f"| {key} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


@style()
def _plot(tests: dict[str, list[dict]], full: dict | None) -> Figure:
    """Compression (axes of the paper's figure 6b) and lost bonds (6a), each test a line."""
    rows = len(tests) + (full is not None) + 1
    figure, axes = new_figure((8.2, 3.8), key_rows=rows)
    axes.remove()
    left, right = figure.subplots(1, 2)
    handles, names = [], []
    for colour, (name, runs) in zip(PALETTE, tests.items()):
        for run in runs:
            line = _draw(left, right, run, colour, 0.8)
        handles.append(line)
        names.append(f"{name}, {GRAINS} grains, {len(runs)} of {len(SEEDS)} seeds")
    if full is not None:
        handles.append(_draw(left, right, full, BLACK, 1.6))
        names.append(f"adaptive, {ALL} grains")
    handles.append(left.errorbar([1000], [0.985], [0.005], fmt="s", color="red", zorder=9))
    right.plot([1000, 1000], [1, 1.5], color="red", linewidth=3, zorder=9)
    names.append(PAPER)
    left.set_ylabel("$e/e_0$")
    left.set_ylim(None, 1.005)
    right.set_ylabel("Bonds lost [%]")
    for axes in (left, right):
        axes.set_xscale("log")
        axes.set_xlim(5, 1500)
        axes.set_xlabel("Axial stress [kPa]")
    draw_key(figure, handles, names)
    return figure


def _draw(left, right, run: dict, colour: str, width: float):
    curve = run["curve"]
    stress = curve["axial_stress [kPa]"]
    line = left.plot(stress, curve["void_ratio_normalised [1]"], color=colour, linewidth=width)[0]
    right.plot(stress, curve["bonds_lost [%]"], color=colour, linewidth=width)
    return line


if __name__ == "__main__":
    main()
