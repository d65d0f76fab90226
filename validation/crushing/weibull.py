"""Do stamped grains follow a Weibull line? Groups of thirty grains, without and with scatter of bond strength."""

import json

from studies import FIGURES, base, crushed

from grus.plotting import save, weibull_plot
from grus.statistics import fit_weibull

GRAINS = 30
SCATTER = {"bond.scatter.kind": "normal", "bond.scatter.coefficient_of_variation": 0.3}


def main() -> None:
    found = {
        "stamp": study("weibull", "stamped grains", 10, {}),
        "stamp and bond scatter": study("weibull-scatter", "bond scatter 0.3", 5, SCATTER),
    }
    (FIGURES / "weibull.json").write_text(json.dumps(found, indent=1) + "\n")
    print(json.dumps(found, indent=1))


def study(name: str, title: str, groups: int, overrides: dict) -> dict:
    """Fits of each group of thirty and of all of them together."""
    group = crushed(name, base().with_overrides(overrides), groups * GRAINS)
    parts = group.strengths.reshape(groups, GRAINS)
    fits = [fit_weibull(part, seed=group.card.seed) for part in parts]
    whole = group.weibull()
    save(weibull_plot(whole, title=f"{whole.n} grains, {title}"), FIGURES / name)
    return {
        "groups": [{"modulus": f.modulus, "sigma0": f.sigma0, "p": f.p_value} for f in fits],
        "all": {"modulus": whole.modulus, "sigma0": whole.sigma0, "p": whole.p_value},
        "rejected at 5 %": sum(f.p_value < 0.05 for f in fits),
    }


if __name__ == "__main__":
    main()
