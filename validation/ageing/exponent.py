"""Does a grain have the exponent of its bonds? Lives of twenty grains under five constant platen forces each."""

import json
from dataclasses import asdict

import numpy as np
from held_grain import hold_grain
from matplotlib.figure import Figure
from studies import EXPONENT, FIGURES, LAW, base, kept

import grus
from grus.plotting import new_figure, save, style
from grus.plotting.style import BLACK, BLUE

GRAINS, TENSION_GRAINS = 20, 12
LEVELS = (0.65, 0.55, 0.46, 0.39, 0.33)
LOW = 4  # levels from the lowest that the exponent is also told of


def main() -> None:
    life = studied("larger", GRAINS)
    found = {"exponent of the bonds": EXPONENT, "levels": LEVELS, "life [s]": life.tolist()}
    for name, levels in {"all levels": len(LEVELS), f"{LOW} lowest levels": LOW}.items():
        found[name] = exponent(np.log(LEVELS)[-levels:], np.log(life)[:, -levels:])
    tension = studied("tension", TENSION_GRAINS)
    found["driven by tension alone"] = exponent(np.log(LEVELS), np.log(tension))
    found["driven by tension alone"]["life [s]"] = tension.tolist()
    FIGURES.mkdir(exist_ok=True)
    (FIGURES / "exponent.json").write_text(json.dumps(found, indent=1) + "\n")
    save(plot(life, found), FIGURES / "exponent")
    print(
        json.dumps(
            {k: v for k, v in found.items() if k != "life [s]" and k != "driven by tension alone"},
            indent=1,
        )
    )


def studied(driven_by: str, grains: int) -> np.ndarray:
    """Lives (grains, levels) [s]; nan: lived on."""
    tests = [
        kept(f"exponent-{driven_by}-{grain}", lambda grain=grain: lives(grain, driven_by))
        for grain in range(grains)
    ]
    return np.array([[np.nan if t is None else t for t in test["life"]] for test in tests])


def lives(grain: int, driven_by: str) -> dict:
    """Lives of one grain at shares of its own crushing strength."""
    strength = grus.crush(base(), grain).strength
    law = LAW | {"drivenBy": driven_by}
    tests = [asdict(hold_grain(base(), grain, level * strength, **law)) for level in LEVELS]
    return {"strength": strength} | {key: [test[key] for test in tests] for key in tests[0]}


def exponent(level: np.ndarray, life: np.ndarray) -> dict:
    """Common slope of ln life (grains, levels) on -ln force, each grain with a constant of its own; 95 % interval by
    drawing grains with replacement. Grains that lived on under some force are left out and counted.
    """
    complete = life[np.isfinite(life).all(axis=1)]
    x = level - level.mean()
    slopes = -(complete - complete.mean(axis=1, keepdims=True)) @ x / (x @ x)
    draws = np.random.default_rng(1).integers(len(slopes), size=(10_000, len(slopes)))
    return {
        "grains": len(slopes),
        "left out": len(life) - len(slopes),
        "exponent": slopes.mean(),
        "interval": list(np.quantile(slopes[draws].mean(axis=1), [0.025, 0.975])),
        "median of the grains": np.median(slopes),
        "of each grain": slopes.tolist(),
    }


@style()
def plot(life: np.ndarray, found: dict) -> Figure:
    """Life, over that at the lowest force, against force over strength."""
    figure, axes = new_figure()
    level = np.array(LEVELS)
    for row in life:
        axes.plot(level, row / row[-1], "o-", color=BLUE, alpha=0.45, lw=1)
    axes.plot(level, (level / level[-1]) ** -EXPONENT, "--", color=BLACK, lw=1.6)
    axes.plot([], [], "o-", color=BLUE, alpha=0.45, label=f"{len(life)} grains")
    axes.plot([], [], "--", color=BLACK, label=f"exponent of the bonds, {EXPONENT:g}")
    pooled = found["all levels"]
    low, high = pooled["interval"]
    told = f"common exponent {pooled['exponent']:.1f} (95 %: {low:.1f} to {high:.1f})"
    axes.plot([], [], " ", label=told)
    axes.set(xscale="log", yscale="log")
    axes.set_xticks(level, [f"{x:g}" for x in level])
    axes.minorticks_off()
    axes.set_xlabel("Platen force over crushing force of the grain [–]")
    axes.set_ylabel("Life over that at the lowest force [–]")
    axes.legend(loc="lower left")
    return figure


if __name__ == "__main__":
    main()
