"""Diagnoses public recordings of real tests: `python3 diagnose.py [NAME ...]`, by default all of RECORDINGS.

Writes NAME/verdict.json and NAME/report.html beside this file. Runs are kept in results/validation-recordings.
"""

import os
import shutil
import sys
from pathlib import Path

from grus.card import Card
from grus.diagnosis import diagnose
from grus.diagnosis.report import summary, write_report
from grus.errors import GrusError
from grus.public_data import load
from rich.console import Console

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
DATA = Path(os.environ.get("GRUS_SHARED", ROOT.parent / "shared")) / "data"
RESULTS = Path(os.environ.get("GRUS_RESULTS", ROOT / "results")) / "validation-recordings"
RECORDINGS = ("glass-beads", "ice-02", "ice-06", "soil-increments", "soil-rates")
KEPT = ("verdict.json", "report.html")


def main() -> None:
    card = Card.from_file(ROOT / "models" / "quick.toml")
    for name in sys.argv[1:] or RECORDINGS:
        try:
            found = diagnose(load(name, DATA), card, RESULTS / "runs", say=print)
        except GrusError as error:
            print(f"{name}: {error}")
            continue
        write_report(found, RESULTS / name)
        Console().print(summary(found))
        folder = HERE / name
        folder.mkdir(exist_ok=True)
        for file in KEPT:
            shutil.copy(RESULTS / name / file, folder / file)


if __name__ == "__main__":
    main()
