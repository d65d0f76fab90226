"""Calibrates unbonded spheres on the first loading of the glass-bead recording, and compares what follows."""

import json
import os
import sys
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np
from beads import PACKING_MODULUS, Beads, loaded
from grus.errors import GrusError
from grus.files import write_text
from grus.plotting import save
from grus.public_data import load
from grus.record import Record
from grus.recording import segments
from plots import curve_plot, residual_plot

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
DATA = Path(os.environ.get("GRUS_SHARED", ROOT.parent / "shared")) / "data"
RESULTS = Path(os.environ.get("GRUS_RESULTS", ROOT / "results")) / "validation-glass-beads"
FRICTIONS, PACKING = (0.3, 0.5, 0.8), 0.05
GLASS = (
    70e9  # Young's modulus of glass [Pa], with which the search for that of Hertz contacts begins
)
BRANCHES = ("loading", "unloading", "reloading", "second unloading")


def main() -> None:
    recorded = branches(load("glass-beads", DATA))
    found, errors = {}, []
    for friction in FRICTIONS:
        beads = Beads(PACKING_MODULUS, friction, PACKING)
        simulated, _ = run(beads, recorded)
        # Strains of linear contacts go with stress over modulus, but for what the change of shape does.
        beads = replace(
            beads, modulus=round(PACKING_MODULUS / strain_factor(recorded, simulated), -7)
        )
        simulated, porosity = run(beads, recorded)
        errors.append(asdict(beads) | {"porosity": porosity} | deviations(recorded, simulated))
        found[friction] = simulated
    best = min(range(len(errors)), key=lambda i: errors[i]["lateral_stress"]["loading"])
    linear = found[FRICTIONS[best]]
    hertz, calibrated, hertzian = hertz_contacts(recorded, FRICTIONS[best])
    shown = {"linear": linear, "Hertz": calibrated}
    figures = HERE / "figures"
    save(curve_plot(recorded, shown), figures / "curves")
    save(residual_plot(recorded, shown), figures / "residual")
    numbers = {
        "runs": errors,
        "chosen": errors[best],
        "hertz": hertzian,
        "tangent_modulus": {
            "recorded": tangents(recorded["loading"]),
            "linear": tangents(linear["loading"]),
            "hertz, modulus of glass": tangents(hertz["loading"]),
            "hertz, calibrated": tangents(calibrated["loading"]),
        },
        "K0": {
            name: [ratios(recorded[name]), ratios(linear[name]), ratios(calibrated[name])]
            for name in BRANCHES
        },
    }
    write_text(HERE / "numbers.json", json.dumps(numbers, indent=1) + "\n")
    print(json.dumps(numbers, indent=1))


def hertz_contacts(recorded: dict, friction: float) -> tuple[dict, dict, list[dict]]:
    """Branches with the modulus of glass and with the one that fits the loading, and what both are off by."""
    tests, errors = [], []
    beads = Beads(GLASS, friction, PACKING, hertz=True)
    for _ in range(2):
        simulated, porosity = run(beads, recorded)
        errors.append(asdict(beads) | {"porosity": porosity} | deviations(recorded, simulated))
        tests.append(simulated)
        # Strains of Hertz contacts go with stress over modulus to the power 2/3.
        beads = replace(beads, modulus=round(GLASS / strain_factor(recorded, simulated) ** 1.5, -7))
    return tests[0], tests[1], errors


def branches(record: Record) -> dict[str, dict[str, np.ndarray]]:
    """Axial and lateral stress [Pa] and axial strain of each branch."""
    names = ("axial_stress", "lateral_stress", "axial_strain")
    cut = [one.rows for one in segments(record) if one.kind != "hold"]
    return {
        branch: {name: record[name][rows] for name in names}
        for branch, rows in zip(BRANCHES, cut, strict=True)
    }


def run(beads: Beads, recorded: dict) -> tuple[dict[str, dict[str, np.ndarray]], float]:
    """Branches and porosity of the simulation; kept under results."""
    law = "-hertz" if beads.hertz else ""
    name = f"{beads.modulus:g}-{beads.friction:g}-{beads.packing_friction:g}{law}.json"
    path = RESULTS / name
    if not path.exists():
        print(beads, flush=True)
        stresses = [float(recorded["loading"]["axial_stress"][0])]
        stresses += [float(branch["axial_stress"][-1]) for branch in recorded.values()]
        record, porosity = loaded(beads, stresses)
        ends = [int(np.flatnonzero(record["stage"] == i)[-1]) for i in range(len(BRANCHES) + 1)]
        names = ("axial_stress", "lateral_stress", "axial_strain")
        parts = {
            branch: {n: record[n][ends[i] : ends[i + 1] + 1].tolist() for n in names}
            for i, branch in enumerate(BRANCHES)
        }
        path.parent.mkdir(parents=True, exist_ok=True)
        write_text(path, json.dumps({"porosity": porosity, "branches": parts}))
    kept = json.loads(path.read_text())
    parts = {
        branch: {name: np.array(values) for name, values in columns.items()}
        for branch, columns in kept["branches"].items()
    }
    return parts, kept["porosity"]


def strain_factor(recorded: dict, simulated: dict) -> float:
    """By which the simulated strains of the loading must be multiplied to fit best."""
    real = recorded["loading"]["axial_strain"]
    own = at(simulated["loading"], recorded["loading"]["axial_stress"], "axial_strain")
    return float(real @ own / (own @ own))


def at(branch: dict[str, np.ndarray], stress: np.ndarray, name: str) -> np.ndarray:
    """A channel of a branch at these axial stresses."""
    order = np.argsort(branch["axial_stress"])
    return np.interp(stress, branch["axial_stress"][order], branch[name][order])


def deviations(recorded: dict, simulated: dict) -> dict[str, dict[str, float]]:
    """Root-mean-square deviation of strain [-] and lateral stress [Pa] by branch."""
    found: dict[str, dict[str, float]] = {"axial_strain": {}, "lateral_stress": {}}
    for name, by_branch in found.items():
        for branch, real in recorded.items():
            away = at(simulated[branch], real["axial_stress"], name) - real[name]
            by_branch[branch] = float(np.sqrt((away**2).mean()))
    return found


def tangents(branch: dict[str, np.ndarray]) -> list[float]:
    """Mean tangent moduli [Pa] of the first, second and last third of the stress range."""
    stress = np.linspace(branch["axial_stress"][0], branch["axial_stress"][-1], 4)
    return (np.diff(stress) / np.diff(at(branch, stress, "axial_strain"))).tolist()


def ratios(branch: dict[str, np.ndarray]) -> list[float]:
    """Lateral over axial stress at the beginning and the end of a branch."""
    ratio = branch["lateral_stress"] / branch["axial_stress"]
    return [float(ratio[0]), float(ratio[-1])]


if __name__ == "__main__":
    try:
        main()
    except GrusError as error:
        print(error, file=sys.stderr)
        sys.exit(2)
