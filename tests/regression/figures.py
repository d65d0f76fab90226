"""Figures of the small cards: PYTHONPATH=pkg OMP_NUM_THREADS=N /usr/bin/python3 tests/regression/figures.py SPECIMENS

Prints them as JSON. SPECIMENS is a folder that prepared specimens are kept in, so that runs on other numbers of threads
start from the same.
"""

import json
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import grus  # noqa: F401  loads YADE
from grus.card import Card
from grus.crushing import CrushingResult, crush
from grus.oedometer import Analysis, OedometerResult, oedometer

CARDS = Path(__file__).resolve().parents[1] / "cards"
GRAINS = 2


def of_crushing(result: CrushingResult) -> dict:
    return {
        "elements": result.specimen.element_count,
        "bonds": result.bonds,
        "strength": result.strength,
        "peak_closing": result.peak_closing,
        "max_force": result.max_force,
        "tension_breaks": result.tension_breaks,
        "shear_breaks": result.shear_breaks,
        "fragments": result.after.fragment_count,
        "work": float(result.record["work"][-1]),
    }


def of_oedometer(result: OedometerResult) -> dict:
    """By stage, and of the specimen."""
    analysis = Analysis.of(result)
    found = {
        "specimen": {
            "grains": result.prepared.specimen.grain_count,
            "bonds": result.bonds,
            "void_ratio": result.prepared.void_ratio,
        }
    }
    for end, part, row in zip(result.stages, analysis.fragments, analysis.rows):
        found[f"stage {end.number} {end.name}"] = {
            "axial_stress": end.axial_stress,
            "height": end.height,
            "K0": end.K0,
            "tension_breaks": end.tension_breaks,
            "shear_breaks": end.shear_breaks,
            "fragments": part.count,
            "steps": end.steps,
            "work": float(result.record["work"][row]),
        }
    return found


def figures(specimens: Path) -> dict:
    """By name of the run and of what is in it."""
    found = {}
    for name in ("plane", "space"):
        card = Card.from_file(CARDS / f"{name}.toml")
        found[f"crushing {name}"] = {
            f"grain {number}": of_crushing(crush(card, number)) for number in range(GRAINS)
        }
        with TemporaryDirectory() as folder:
            found[f"oedometer {name}"] = of_oedometer(oedometer(card, folder, specimens=specimens))
    return found


if __name__ == "__main__":
    print(json.dumps(figures(Path(sys.argv[1])), indent=1))
