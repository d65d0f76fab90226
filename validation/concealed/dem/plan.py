"""Trials of this generator. Few materials and programs, so that runs without effects serve several trials."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from conceal import Concealment
from constitutive.effects import draw as draw_instrument
from constitutive.plan import concealment
from programs import stages
from trial import Trial

ELEMENT = 1.5e-3  # radius of the elements [m]


@dataclass(frozen=True, eq=False)
class Material:
    """Seeds are `seed`, `seed` + 1 and `seed` + 2."""

    base: dict[str, float]
    program: str
    seed: int


def _base(stiffness: float, strength: float, friction: float) -> dict[str, float]:
    return {
        "stiffness": stiffness,
        "strength": strength,
        "friction": friction,
        "element": ELEMENT,
    }


MATERIAL = Material(_base(0.8, 1.1, 0.6), "small", 20)
OTHER = Material(_base(1.3, 1.6, 0.4), "loops", 30)

# Specimen (0 to 2), grade, effects. What the gauge adds costs no run.
DEVELOPMENT = {
    MATERIAL: (
        (0, "none"),
        (2, "none"),
        (2, "single", "bond_ageing"),
        (0, "single", "wall_friction"),
        (2, "single", "hertzian_contact"),
        (2, "single", "contact_plasticity"),
        (0, "single", "rolling_resistance"),
        (2, "single", "strength_scatter"),
        (2, "single", "loading_too_fast"),
        (0, "single", "wetting_collapse"),
        (0, "single", "platen_compliance"),
        (0, "outside", "friction_wear"),
    ),
}
SEALED = {
    OTHER: (
        (0, "none"),
        (1, "none"),
        (2, "none"),
        (0, "single", "rolling_resistance"),
        (1, "single", "rolling_resistance"),
        (2, "single", "rolling_resistance"),
        (1, "single", "bond_ageing"),
        (2, "single", "loading_too_fast"),
        (0, "single", "wetting_collapse"),
        (2, "single", "contact_plasticity"),
        (1, "single", "hertzian_contact"),
        (2, "single", "platen_compliance"),
        (1, "single", "instrument_drift"),
        (1, "pair", "bond_ageing", "platen_compliance"),
        (0, "pair", "wetting_collapse", "instrument_drift"),
    ),
}


def draw(effect: str, program: str, rng: np.random.Generator) -> dict[str, float]:
    """Parameters of an effect; strains of the gauge as in the other generator."""

    def between(low: float, high: float) -> float:
        return float(f"{low * (high / low) ** rng.random():.4g}")

    match effect:
        case "bond_ageing":
            return {"exponent": between(15, 25), "reference_time": between(0.003, 0.01)}
        case "wall_friction":
            return {"friction": between(0.15, 0.4)}
        case "hertzian_contact":
            return {"force": between(2e3, 5e3)}
        case "contact_plasticity":
            return {"ratio": between(2, 3)}
        case "rolling_resistance":
            return {"rolling": between(0.6, 1.5)}
        case "strength_scatter":
            return {"variation": between(0.5, 0.9)}
        case "wetting_collapse":
            stage, hours = _longest(program)
            return {
                "lost": between(0.4, 0.6),
                "stage": stage,
                "at": round(hours * between(0.2, 0.7), 2),
            }
        case "loading_too_fast":
            return {"speed": between(1.0, 2.5)}
        case "friction_wear":
            return {"lost": between(0.04, 0.08)}
        case "grain_swelling":
            return {"growth": between(2e-5, 6e-5)}
        case "temperature_cycles":
            return {"amplitude": between(5e-5, 1.5e-4)}
        case "load_leak":
            return {"lost": between(0.08, 0.2), "time": between(4, 20)}
    return draw_instrument(effect, program, rng)


def _longest(program: str) -> tuple[int, float]:
    """Number and hours of the longest hold under the highest stress."""
    holds = [(s.end, s.hours, n) for n, s in enumerate(stages(program)) if s.hold]
    _, hours, number = max(holds)
    return number, hours


def trials(kind: str, seed: int) -> Iterator[Trial]:
    """Those of DEVELOPMENT or SEALED."""
    number = 0
    for material, rows in {"development": DEVELOPMENT, "sealed": SEALED}[kind].items():
        # One draw of an effect for all trials of a specimen that have it, so that its run serves them all.
        for specimen, grade, *names in rows:
            number += 1
            rng = np.random.default_rng([seed, 500 + number])
            drifts = not {"instrument_drift", "load_leak", "grain_swelling"} & set(names)
            how = concealment(rng, drifts=drifts and "temperature_cycles" not in names)
            acting = {
                name: draw(name, material.program, _own(seed, material, specimen, name))
                for name in names
            }
            channels = tuple(
                channel
                for channel, likely in (
                    ("base_stress", 0.75 if "wall_friction" in names else 0.3),
                    ("lateral_stress", 0.2),
                    ("ae_events", 0.5),
                )
                if rng.random() < likely
            )
            yield Trial(
                grade,
                material.program,
                material.base,
                acting,
                channels,
                how,
                material.seed + specimen,
            )


def _own(seed: int, material: Material, specimen: int, effect: str) -> np.random.Generator:
    return np.random.default_rng([seed, material.seed, specimen, *effect.encode()])
