"""How well trials were judged."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

CLEAR = 2.0
"""Effect over the scatter of seeds and noise from which it ought to be named."""
BINS = (0.0, 0.05, 0.2, 0.4, 0.6, 0.8, 0.95, 1.0)
"""Of stated probabilities."""
BETTER = 3.0
"""Factor by which the error on stages left out ought to fall."""


@dataclass(frozen=True)
class Count:
    """good of all."""

    good: int
    all: int

    @property
    def share(self) -> float:
        return self.good / self.all if self.all else float("nan")


@dataclass(frozen=True)
class Score:
    """named: clear single effects named, and nothing else. pairs: both of a clear pair named. quiet: trials without effect in
    which no mechanism was named. unknown: effects outside the library called unknown or "cannot tell". weak: weak effects
    about which nothing wrong was said. confusion: truth -> verdict -> trials. reliability: for bins of stated probability
    of a mechanism: mean stated, share true, number. brier: mean square error of these probabilities. improved: errors on
    stages left out that fell by BETTER or more where an effect was named rightly. rows: trial by trial.
    """

    named: Count
    pairs: Count
    quiet: Count
    unknown: Count
    weak: Count
    confusion: dict[str, dict[str, int]]
    reliability: list[dict[str, float]]
    brier: float
    improved: Count
    rows: list[dict[str, Any]]

    def to_dict(self) -> dict[str, Any]:
        return asdict(self)


def score(truth: Mapping[str, Mapping], verdicts: Mapping[str, Mapping]) -> Score:
    """truth: answers by trial. verdicts: what verdict.json has, by trial; trials without one are left out."""
    rows = [_row(name, truth[name], verdicts[name]) for name in sorted(verdicts)]
    of = {grade: [r for r in rows if r["grade"] == grade] for grade in {r["grade"] for r in rows}}
    clear = [r for r in of.get("single", []) if r["ratio"] >= CLEAR]
    pairs = [r for r in of.get("pair", []) if r["ratio"] >= CLEAR]
    confusion: dict[str, dict[str, int]] = {}
    for row in rows:
        said = "+".join(row["named"]) or row["verdict"]
        into = confusion.setdefault("+".join(row["effects"]) or "none", {})
        into[said] = into.get(said, 0) + 1
    stated, true = _stated(rows)
    fits = [r for r in rows if r["right"] and r["falls_by"] is not None]
    return Score(
        named=_count(clear),
        pairs=_count(pairs),
        quiet=_count(of.get("none", [])),
        unknown=_count(of.get("outside", [])),
        weak=_count(of.get("weak", [])),
        confusion=confusion,
        reliability=_reliability(stated, true),
        brier=float(np.mean((stated - true) ** 2)) if len(stated) else float("nan"),
        improved=Count(sum(r["falls_by"] >= BETTER for r in fits), len(fits)),
        rows=rows,
    )


def _count(rows: list[dict]) -> Count:
    return Count(sum(r["right"] for r in rows), len(rows))


def _row(name: str, answer: Mapping, verdict: Mapping) -> dict[str, Any]:
    effects = [one["name"] for one in answer["effects"]]
    known = {one["name"] for one in answer["effects"] if one["in_library"]}
    named = [one["name"] for one in verdict["mechanisms"]] if verdict["verdict"] == "named" else []
    wrong = set(named) - known - set(answer["tolerated"])
    grade = answer["grade"]
    if grade in ("single", "pair"):
        right = known <= set(named) and not wrong
    elif grade == "none":
        right = not wrong and verdict["verdict"] != "unknown"
    elif grade == "outside":
        right = verdict["verdict"] in ("unknown", "cannot_tell") and "error" not in verdict
    else:
        right = not wrong
    before, after = verdict.get("before"), verdict.get("after")
    falls_by = None
    if before and after:
        falls_by = before["left_out"]["rmse_strain"] / max(after["left_out"]["rmse_strain"], 1e-12)
    ratios = [one["ratio_beyond_calibration"] for one in answer["effects"]]
    return {
        "trial": name,
        "grade": grade,
        "generator": answer["generator"],
        "effects": effects,
        "ratio": min(ratios, default=0.0),
        "tolerated": list(answer["tolerated"]),
        "verdict": verdict["verdict"],
        "named": named,
        "probability": verdict["probability"],
        "right": bool(right),
        "falls_by": falls_by,
    }


def _stated(rows: list[dict]) -> tuple[np.ndarray, np.ndarray]:
    """Stated probability of each mechanism in each trial, and whether it was at work."""
    pairs = [
        (p, name in row["effects"])
        for row in rows
        for name, p in row["probability"].items()
        if name not in ("nothing", "unknown") and name not in row["tolerated"]
    ]
    return np.array([p for p, _ in pairs]), np.array([t for _, t in pairs], dtype=float)


def _reliability(stated: np.ndarray, true: np.ndarray) -> list[dict[str, float]]:
    result = []
    for low, high in zip(BINS[:-1], BINS[1:]):
        own = (stated >= low) & ((stated < high) | (high == BINS[-1]))
        if own.any():
            result.append(
                {
                    "low": low,
                    "high": high,
                    "stated": float(stated[own].mean()),
                    "true": float(true[own].mean()),
                    "number": int(own.sum()),
                }
            )
    return result
