"""Do lives under one force have the Weibull slope m/n? One grain in a hundred strengths, and sixty different grains."""

import json
from dataclasses import asdict

import numpy as np
from held_grain import hold_grain
from matplotlib.figure import Figure
from studies import EXPONENT, FIGURES, LAW, base, kept

import grus
from grus.crushing import CrushingTest
from grus.plotting import save, style
from grus.plotting.style import BLACK, BLUE
from grus.specimen.from_card import grain_from_card
from grus.statistics import fit_weibull, survival_points

MODULUS = 6.0
DRAWS, GRAINS = 100, 60
SHARE = 0.45
"""Stress of the hold over the characteristic strength [-]."""


def main() -> None:
    same = [kept(f"same-{i}", lambda i=i: same_grain(i)) for i in range(DRAWS)]
    strengths = [
        kept(f"strength-{i}", lambda i=i: {"strength": strength(i)}) for i in range(GRAINS)
    ]
    stress = SHARE * fit_weibull([s["strength"] for s in strengths]).sigma0
    other = [
        kept(f"other-{i}", lambda i=i: asdict(hold_grain(base(), i, stress, **LAW)))
        for i in range(GRAINS)
    ]
    groups = {
        "one grain, strengths scattered": summary(
            [s["strength"] for s in same], [s["life"] for s in same]
        ),
        "different grains": summary([s["strength"] for s in strengths], [s["life"] for s in other]),
    }
    FIGURES.mkdir(exist_ok=True)
    save(plot(groups), FIGURES / "weibull-lives")
    (FIGURES / "weibull-lives.json").write_text(json.dumps(groups, indent=1) + "\n")
    for group in groups.values():
        del group["strengths [Pa]"], group["lives [s]"]
    print(json.dumps(groups, indent=1))


def scattered() -> grus.Card:
    """All bonds of a grain share a Weibull factor, which follows from the number that the grain is given."""
    return base().with_overrides({"bond.grain_scatter.modulus": MODULUS})


def same_grain(number: int) -> dict:
    """Strength and life of grain 1 with the strength factor of grain `number`."""
    specimen = grain_from_card(base(), 1)
    sound = kept("same-sound", lambda: {"strength": strength(1)})["strength"]
    crushed = CrushingTest(scattered(), number, specimen).run()
    life = hold_grain(scattered(), number, SHARE * sound, specimen=specimen, **LAW)
    return {"strength": crushed.strength} | asdict(life)


def strength(grain: int) -> float:
    """Crushing strength [Pa] of a grain of the card."""
    return grus.crush(base(), grain).strength


def summary(strengths: list[float], lives: list[float | None]) -> dict:
    """Weibull fits of both; grains that the load crushed at once have no life and are left out of that fit, and those that
    lived on are censored at the longest life."""
    crushed = sum(life == 0 for life in lives)
    told = [life for life in lives if life != 0]
    longest = max(life for life in told if life is not None)
    by_strength = fit_weibull(strengths)
    by_life = fit_weibull(
        [longest if life is None else life for life in told],
        censored=[life is None for life in told] if None in told else None,
    )
    return {
        "strengths [Pa]": strengths,
        "lives [s]": lives,
        "crushed by the load": crushed,
        "lived on": told.count(None),
        "modulus m of strength": by_strength.modulus,
        "its interval": by_strength.modulus_ci,
        "m/n": by_strength.modulus / EXPONENT,
        "shape of life": by_life.modulus,
        "shape's interval": by_life.modulus_ci,
        "scale of life [s]": by_life.sigma0,
    }


@style()
def plot(groups: dict) -> Figure:
    """Weibull plots of life, with the line fitted and one of the slope m/n through the middle of the points."""
    figure = Figure(figsize=(8.4, 3.9), layout="constrained")
    for axes, (name, group) in zip(figure.subplots(1, 2), groups.items()):
        lives = np.array([np.nan if t is None else t for t in group["lives [s]"]])
        alive = np.isnan(lives[lives != 0])
        points = survival_points(
            np.where(alive, np.nanmax(lives), lives[lives != 0]), alive if alive.any() else None
        )
        x, y = points.abscissa / np.log(10), points.ordinate
        axes.plot(x, y, "o", color=BLUE, ms=3.5, label=f"{len(x)} lives")
        ends = np.array([x.min(), x.max()])
        centre = np.log10(group["scale of life [s]"])
        for slope, mark, colour, label in (
            (group["shape of life"], "-", BLUE, "fit, slope {:.2f}"),
            (group["m/n"], "--", BLACK, "m/n = {:.2f}"),
        ):
            line = slope * np.log(10) * (ends - centre)
            axes.plot(ends, line, mark, color=colour, label=label.format(slope))
        axes.set_title(name)
        axes.set_xlabel("log$_{10}$ of life [s]")
        axes.set_ylim(y.min() - 0.3, y.max() + 0.5)
        axes.legend(loc="upper left")
    figure.axes[0].set_ylabel("ln(−ln of the share that survives) [–]")
    return figure


if __name__ == "__main__":
    main()
