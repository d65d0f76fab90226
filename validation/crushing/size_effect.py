"""Strength against grain diameter, against the weakest-link slope -dim/m."""

import json

from studies import FIGURES, base, crushed

import grus
from grus.plotting import save, size_effect_plot

GRAINS = 40
DIAMETERS = (6.3, 8.9, 12.6, 17.8)  # mm
MODELS = {
    "stamp": {},
    "bond-scatter": {"bond.scatter.kind": "weibull", "bond.scatter.modulus": 2.0},
    "grain-scatter": {
        "bond.grain_scatter.modulus": 4.0,
        "bond.grain_scatter.reference_diameter": "12.6 mm",
    },
}


def main() -> None:
    found = {}
    for model, overrides in MODELS.items():
        fits = []
        for diameter in DIAMETERS:
            card = base().with_overrides(overrides | {"agglomerate.diameter": f"{diameter} mm"})
            fits.append(crushed(f"size-{model}-{diameter}", card, GRAINS).weibull())
        effect = grus.size_effect([1e-3 * d for d in DIAMETERS], fits, dimension=2)
        save(size_effect_plot(effect, title=model), FIGURES / f"size-effect-{model}")
        found[model] = {
            "slope": effect.slope,
            "slope_ci": effect.slope_ci,
            "expected": effect.expected_slope,
            "expected_ci": effect.expected_slope_ci,
            "modulus": effect.modulus,
            "p": effect.agreement_p_value,
        }
    (FIGURES / "size-effect.json").write_text(json.dumps(found, indent=1) + "\n")
    print(json.dumps(found, indent=1))


if __name__ == "__main__":
    main()
