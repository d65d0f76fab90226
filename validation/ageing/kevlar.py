"""The power law on real delayed failures: Kevlar/epoxy pressure vessels held at four pressures, some of them never burst."""

import json
import os
import sys
from pathlib import Path

import numpy as np
import pandas as pd
from matplotlib.figure import Figure
from scipy.optimize import brentq, minimize
from scipy.stats import chi2
from studies import FIGURES

from grus.plotting import new_figure, save, style
from grus.plotting.style import BLACK, PALETTE

BESIDE = Path(__file__).resolve().parents[2].parent / "shared"
DATA = Path(os.environ.get("GRUS_SHARED", BESIDE)) / "data" / "static-fatigue" / "kevlarvessels.csv"
REFERENCE = 4000.0
"""Pressure [psi] that the life scale is told of."""
PSI = 6894.757e-6
"""[MPa]"""


def main() -> None:
    if not DATA.exists():
        sys.exit(f"{DATA}: not found; set GRUS_SHARED to the folder that holds data/")
    data = pd.read_csv(DATA)
    found = fit(data)
    FIGURES.mkdir(exist_ok=True)
    (FIGURES / "kevlar.json").write_text(json.dumps(found, indent=1) + "\n")
    save(plot(data, found), FIGURES / "kevlar")
    print(json.dumps(found, indent=1))


def terms(data: pd.DataFrame, exponents: np.ndarray, scale: float, shape: np.ndarray) -> float:
    """Minus log-likelihood of lives that are Weibull with the scale exp(`scale`) (pressure/REFERENCE)^-n and a shape;
    a vessel that had not burst counts with its survival. `exponents` and `shape`: one for all or one a row.
    """
    log_scale = scale - exponents * np.log(data.pressure / REFERENCE)
    reduced = shape * (np.log(data.time) - log_scale)
    density = np.log(shape) - np.log(data.time) + reduced
    return -float(
        (data["count"] * (np.where(data.event == 1, density, 0.0) - np.exp(reduced))).sum()
    )


def fit(data: pd.DataFrame) -> dict:
    """Maximum likelihood with 95 % profile intervals, and whether one line and one shape are enough."""

    def common(p: np.ndarray) -> float:
        return terms(data, p[0], p[1], np.exp(p[2]))

    def free(p: np.ndarray) -> float:
        """A scale and a shape of its own at each pressure."""
        levels = sorted(data.pressure.unique())
        rows = data.pressure.map({level: i for i, level in enumerate(levels)}).to_numpy()
        zero = np.zeros(len(data))
        return terms(data, zero, p[:4][rows], np.exp(p[4:])[rows])

    best = minimize(common, [20.0, np.log(1e3), 0.0], method="Nelder-Mead", options=_PRECISE)
    saturated = minimize(free, [9, 8, 7, 5, 0, 0, 0, 0], method="Nelder-Mead", options=_PRECISE)
    saturated = minimize(free, saturated.x, method="Nelder-Mead", options=_PRECISE)
    low, high = zip(*(profile(common, best.x, i) for i in range(3)))
    ratio = 2 * (best.fun - saturated.fun)
    return {
        "vessels": int(data["count"].sum()),
        "burst": int(data.loc[data.event == 1, "count"].sum()),
        "exponent n": best.x[0],
        "its interval": [low[0], high[0]],
        "shape of life": float(np.exp(best.x[2])),
        "shape's interval": [float(np.exp(low[2])), float(np.exp(high[2]))],
        "scale of life at 4000 psi [h]": float(np.exp(best.x[1])),
        "modulus of strength that m = n shape implies": float(best.x[0] * np.exp(best.x[2])),
        "p of one line and one shape against one fit a pressure": float(chi2.sf(ratio, 8 - 3)),
    }


def profile(function, best: np.ndarray, index: int) -> tuple[float, float]:
    """Where twice the likelihood ratio of a parameter, the others at their best, reaches the 95 % point of chi2."""
    rise = function(best) + chi2.ppf(0.95, 1) / 2

    def excess(value: float) -> float:
        others = np.delete(best, index)
        found = minimize(
            lambda p: function(np.insert(p, index, value)),
            others,
            method="Nelder-Mead",
            options=_PRECISE,
        )
        return found.fun - rise

    step = max(1.0, abs(best[index]))
    return brentq(excess, best[index] - step, best[index]), brentq(
        excess, best[index], best[index] + step
    )


_PRECISE = {"xatol": 1e-8, "fatol": 1e-10, "maxiter": 20_000, "maxfev": 20_000}


@style()
def plot(data: pd.DataFrame, found: dict) -> Figure:
    """Lives against pressure, with the fitted quantiles."""
    figure, axes = new_figure()
    for pressure, colour in zip(sorted(data.pressure.unique()), PALETTE):
        here = data[data.pressure == pressure]
        burst, whole = here[here.event == 1], here[here.event == 0]
        axes.plot(burst.time, burst.pressure * PSI, "o", color=colour, alpha=0.6, ms=4)
        label = f"{whole['count'].sum()} still whole" if len(whole) else None
        axes.plot(whole.time, whole.pressure * PSI, ">", color=colour, ms=8, label=label)
    pressure = np.linspace(3200, 4500, 50)
    scale = found["scale of life at 4000 psi [h]"] * (pressure / REFERENCE) ** -found["exponent n"]
    for share, mark in ((0.1, ":"), (0.5, "-"), (0.9, ":")):
        life = scale * (-np.log1p(-share)) ** (1 / found["shape of life"])
        axes.plot(life, pressure * PSI, mark, color=BLACK, lw=1.3)
    axes.plot([], [], "-", color=BLACK, label="median of the fit")
    axes.plot([], [], ":", color=BLACK, label="10 % and 90 %")
    low, high = found["its interval"]
    axes.plot([], [], " ", label=f"n = {found['exponent n']:.1f} (95 %: {low:.1f} to {high:.1f})")
    axes.set(xscale="log", xlim=(1, 1e5))
    axes.set_xlabel("Time to failure [h]")
    axes.set_ylabel("Pressure [MPa]")
    axes.legend(loc="lower left")
    return figure


if __name__ == "__main__":
    main()
