"""Energy balance of the crushing of one grain."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from grus.card import Card
from grus.crushing.test import crush
from grus.verification.row import Row, compare

PART = "energy"
MODEL = Path(__file__).resolve().parents[3] / "models" / "montesinho.toml"


def energy_rows() -> Iterator[Row]:
    """Balance at the end of the test and at its worst moment after the peak."""
    result = crush(Card.from_file(MODEL))
    r = result.record
    accounted = sum(
        r[name]
        for name in (
            "elastic_energy",
            "kinetic_energy",
            "released_energy",
            "sliding_work",
            "damped_energy",
        )
    )
    note = (
        "Work of the platens = elastic + kinetic + released by bonds + sliding + taken by damping."
    )
    case = f"crushing of grain 0 of {MODEL.name}"
    yield compare(PART, case, "energy at the end", "J", r["work"][-1], accounted[-1], 0.01, note)
    after = np.flatnonzero(r["closing"] >= result.peak_closing)
    error = np.abs(accounted - r["work"])[after]
    worst = after[error.argmax()]
    yield compare(
        PART,
        case,
        "energy at its worst after the peak",
        "J",
        r["work"][worst],
        accounted[worst],
        0.01,
        f"{note} Of {len(after)} records from the peak on the one with the largest error.",
    )
