"""Do stamped grains follow a Weibull line? Ten groups of thirty grains, and the shape of all three hundred."""

import json

from studies import FIGURES, base, crushed

from grus.plotting import save, weibull_plot
from grus.statistics import fit_weibull

GROUPS, GRAINS = 10, 30


def main() -> None:
    group = crushed("weibull", base(), GROUPS * GRAINS)
    strengths = group.strengths
    fits = [
        fit_weibull(strengths[i * GRAINS : (i + 1) * GRAINS], seed=group.card.seed)
        for i in range(GROUPS)
    ]
    whole = fit_weibull(strengths, seed=group.card.seed)
    save(weibull_plot(whole, title="300 stamped grains"), FIGURES / "weibull-300")
    save(weibull_plot(fits[0], title="30 stamped grains"), FIGURES / "weibull-30")
    found = {
        "groups": [{"modulus": f.modulus, "sigma0": f.sigma0, "p": f.p_value} for f in fits],
        "all": {"modulus": whole.modulus, "sigma0": whole.sigma0, "p": whole.p_value},
        "rejected at 5 %": sum(f.p_value < 0.05 for f in fits),
    }
    (FIGURES / "weibull.json").write_text(json.dumps(found, indent=1) + "\n")
    print(json.dumps(found, indent=1))


if __name__ == "__main__":
    main()
