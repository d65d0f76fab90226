"""The effects of this generator: their parameters, drawn at random, and how one is made larger or smaller."""

from dataclasses import asdict, fields, replace

import numpy as np

from constitutive.apparatus import Apparatus
from constitutive.rockfill import Rockfill
from constitutive.test import run
from curve import Curve
from programs import stages

INSIDE = (
    "bond_ageing",
    "wall_friction",
    "platen_compliance",
    "hertzian_contact",
    "contact_plasticity",
    "strength_scatter",
    "wetting_collapse",
    "loading_too_fast",
    "instrument_drift",
)
OUTSIDE = ("pore_water", "swelling", "load_leak", "thermal_strain", "healing")
# Hardly to be told from a recalibration, at any size.
TWINS = ("contact_plasticity", "strength_scatter")
CHANNELS = ("base_stress", "ae_events")

# Parameter that is the size of an effect, and the largest value that is still plausible.
SIZE = {
    "bond_ageing": ("delayed", 4e-4),
    "wall_friction": ("wall_friction", 0.3),
    "platen_compliance": ("toe", 2e-3),
    "hertzian_contact": None,
    "contact_plasticity": ("plasticity", 5.0),
    "strength_scatter": ("spread", 0.9),
    "wetting_collapse": ("collapse", 0.6),
    "loading_too_fast": ("overstress", 120.0),
    "instrument_drift": ("drift", 1e-3),
    "pore_water": ("drainage_time", 8.0),
    "swelling": ("swelling", 2e-3),
    "load_leak": ("leak", 0.3),
    "thermal_strain": ("thermal", 4e-4),
    "healing": ("healing", 0.12),
}


def draw(effect: str, program: str, rng: np.random.Generator) -> dict[str, float]:
    """Parameters of an effect, fields of Rockfill or Apparatus."""

    def between(low: float, high: float) -> float:
        return float(f"{low * (high / low) ** rng.random():.4g}")

    match effect:
        case "bond_ageing":
            found = {"delayed": between(7e-5, 2e-4), "delayed_power": between(1.5, 3)}
            return found | {"delayed_time": between(0.1, 1)}
        case "wall_friction":
            return {"wall_friction": between(0.06, 0.16), "mobilised": between(1e-4, 4e-4)}
        case "platen_compliance":
            found = {"compliance": between(2e-4, 5e-4), "toe": between(2e-4, 6e-4)}
            return found | {"toe_stress": between(15, 40)}
        case "hertzian_contact":
            return {"exponent": 0.6667}
        case "contact_plasticity":
            return {"plasticity": between(1.8, 3.2)}
        case "strength_scatter":
            return {"spread": between(0.35, 0.7)}
        case "wetting_collapse":
            found = {"collapse": between(0.2, 0.4), "collapse_at": _wetting(program, rng)}
            return found | {"collapse_time": between(0.05, 0.5)}
        case "loading_too_fast":
            return {"overstress": between(30, 80)}
        case "instrument_drift":
            return {"drift": float(rng.choice([-1, 1])) * between(4e-5, 2e-4)}
        case "pore_water":
            return {"drainage_time": between(1, 5)}
        case "swelling":
            return {"swelling": between(3e-4, 8e-4)}
        case "load_leak":
            return {"leak": between(0.06, 0.15), "leak_time": between(4, 20)}
        case "thermal_strain":
            return {"thermal": between(4e-5, 1e-4), "thermal_phase": between(0.5, 6)}
        case "healing":
            return {"healing": between(0.03, 0.06)}
    raise ValueError(f"{effect}: none of {INSIDE + OUTSIDE}")


def _wetting(program: str, rng: np.random.Generator) -> float:
    """Time [h] in the hold under the highest stress, the longest of them."""
    begin, best = 0.0, (0.0, 0.0, 0.0)
    for stage in stages(program):
        if stage.hold:
            best = max(best, (stage.end, stage.hours, begin))
        begin += stage.hours
    return round(best[2] + best[1] * (0.2 + 0.5 * rng.random()), 2)


def scaled(effect: str, parameters: dict[str, float], factor: float) -> dict[str, float] | None:
    """The same with another size; None where that makes no sense."""
    if SIZE[effect] is None:
        return None
    name, largest = SIZE[effect]
    one = 1.0 if name == "plasticity" else 0.0  # the value that has no effect
    value = one + (parameters[name] - one) * factor
    if abs(value) > largest:
        return None
    changed = {name: float(f"{value:.4g}")}
    if effect == "platen_compliance":
        changed["compliance"] = float(f"{parameters['compliance'] * factor:.4g}")
    return parameters | changed


def draw_base(rng: np.random.Generator) -> dict[str, float]:
    """What a diagnosis calibrates: factors on stiffness and strength, and the coefficient of friction."""
    return {
        "stiffness": round(0.7 * (1.6 / 0.7) ** rng.random(), 3),
        "strength": round(1.0 * 2.2 ** rng.random(), 3),
        "friction": round(0.35 + 0.35 * rng.random(), 3),
    }


def simulate(
    base: dict[str, float], effects: dict[str, dict[str, float]], program: str, seed: int
) -> Curve:
    """The test of one specimen. Hertzian contacts go with a softer material: theirs is the strain that shows it."""
    plain = Rockfill()
    material = replace(
        plain,
        elastic=plain.elastic / base["stiffness"] * base.get("softness", 1.0),
        sliding=plain.sliding / base["stiffness"] * 0.5 / base["friction"],
        rearrangement=plain.rearrangement / base["stiffness"] * 0.5 / base["friction"],
        yield_stress=plain.yield_stress * base["strength"] ** 0.7,
        breakage=plain.breakage / base["strength"] ** 0.5,
    )
    values = {name: v for parameters in effects.values() for name, v in parameters.items()}
    known = {field.name for field in fields(Rockfill)}
    material = replace(material, **{k: v for k, v in values.items() if k in known})
    apparatus = Apparatus(**{k: v for k, v in values.items() if k in asdict(Apparatus())})
    return run(material, apparatus, program, seed)


def others(seed: int, count: int) -> list[int]:
    """Seeds of other specimens of the same material."""
    return [10_000 * (k + 1) + seed for k in range(count)]
