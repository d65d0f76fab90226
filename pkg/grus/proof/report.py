"""Files of a score: tables and pictures."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

from grus.files import write_text
from grus.plotting.style import save, style
from grus.proof.score import Score
from grus.proof.summary import summary


def write_report(found: Score, folder: str | Path) -> list[str]:
    """Writes trials.csv, summary.txt, confusion.png and reliability.png beside score.json; returns the names of all."""
    folder = Path(folder)
    rows = [
        {**row, "effects": "+".join(row["effects"]), "named": "+".join(row["named"])}
        for row in found.rows
    ]
    table = pd.DataFrame(rows).drop(columns=["probability", "tolerated"])
    write_text(folder / "trials.csv", table.to_csv(index=False))
    write_text(folder / "summary.txt", summary(found) + "\n")
    with style():
        save(_confusion(found), folder / "confusion")
        save(_reliability(found), folder / "reliability")
    return ["score.json", "trials.csv", "summary.txt", "confusion.png", "reliability.png"]


def _confusion(found: Score) -> plt.Figure:
    truths = sorted(found.confusion)
    said = sorted({s for row in found.confusion.values() for s in row})
    counts = np.array([[found.confusion[t].get(s, 0) for s in said] for t in truths])
    figure, axes = plt.subplots(figsize=(2.5 + 0.45 * len(said), 2 + 0.28 * len(truths)))
    axes.grid(False)
    axes.imshow(counts, cmap="Blues", vmin=0, vmax=max(counts.max(), 1) * 1.5, aspect="auto")
    for (i, j), count in np.ndenumerate(counts):
        if count:
            axes.text(j, i, str(count), ha="center", va="center")
    axes.set_xticks(range(len(said)), [s.replace("_", " ") for s in said], rotation=60, ha="right")
    axes.set_yticks(range(len(truths)), [t.replace("_", " ") for t in truths])
    axes.set_xlabel("verdict")
    axes.set_ylabel("what was concealed")
    return figure


def _reliability(found: Score) -> plt.Figure:
    figure, axes = plt.subplots(figsize=(4.2, 4.2))
    axes.plot([0, 1], [0, 1], color="0.6", lw=1)
    stated = [b["stated"] for b in found.reliability]
    true = np.array([b["true"] for b in found.reliability])
    number = np.array([b["number"] for b in found.reliability])
    error = np.sqrt(np.maximum(true * (1 - true), 0.25 / (number + 1)) / number)
    axes.errorbar(stated, true, error, fmt="o", capsize=3)
    for x, y, n in zip(stated, true, number):
        axes.annotate(f" {n}", (x, y))
    axes.set_xlabel("stated probability of a mechanism")
    axes.set_ylabel("share in which it was at work")
    axes.set_xlim(-0.03, 1.03)
    axes.set_ylim(-0.03, 1.03)
    return figure
