"""How the Weibull modulus answers to what scatters: stamp, bond strength, grain strength, missing elements."""

import json

import numpy as np
from matplotlib.figure import Figure
from studies import FIGURES, base, crushed

from grus.plotting import save, style
from grus.plotting.style import BLUE

GRAINS = 60
KNOBS = {
    "Deviation of the stamp radius [mm]": [
        (value, {"agglomerate.stamp_deviation": f"{value} mm"})
        for value in (0.0, 0.1, 0.2, 0.3, 0.4)
    ],
    "Coefficient of variation of bond strength [–]": [
        (0.0, {}),
        *(
            (cv, {"bond.scatter.kind": "normal", "bond.scatter.coefficient_of_variation": cv})
            for cv in (0.1, 0.2, 0.3, 0.45)
        ),
    ],
    "Weibull modulus of the grain factor [–]": [
        (m, {"bond.grain_scatter.modulus": m}) for m in (2.0, 3.0, 5.0, 8.0)
    ],
    "Missing elements [%]": [
        (100 * share, {"agglomerate.missing_fraction": share}) for share in (0.0, 0.05, 0.1, 0.2)
    ],
}


def main() -> None:
    found = {}
    for knob, settings in KNOBS.items():
        rows = []
        for value, overrides in settings:
            name = "-".join(f"{k.split('.')[-1]}={v}" for k, v in overrides.items()) or "base"
            fit = crushed(name.replace(" ", ""), base().with_overrides(overrides), GRAINS).weibull()
            rows.append([value, fit.modulus, *fit.modulus_ci, fit.sigma0])
        found[knob] = rows
    (FIGURES / "knobs.json").write_text(json.dumps(found, indent=1) + "\n")
    save(plot(found), FIGURES / "knobs")
    print(json.dumps(found, indent=1))


@style()
def plot(found: dict) -> Figure:
    """Modulus with its interval against each knob."""
    figure = Figure(figsize=(8, 6), layout="constrained")
    for axes, (knob, rows) in zip(figure.subplots(2, 2, sharey=True).ravel(), found.items()):
        value, modulus, low, high, _ = np.array(rows).T
        axes.errorbar(
            value, modulus, [modulus - low, high - modulus], fmt="o-", color=BLUE, capsize=3
        )
        axes.set_xlabel(knob)
        axes.set_ylim(bottom=0)
    figure.supylabel("Weibull modulus $m$ [–], with 95 % interval", fontsize=10)
    return figure


if __name__ == "__main__":
    main()
