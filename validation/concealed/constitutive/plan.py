"""Trials of this generator: drawn from one seed, so that another seed makes another set."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from conceal import Concealment
from constitutive import effects
from trial import STRONG, WEAK, Trial, ratios

GROWTH = 1.35  # of an effect from try to try
TRIES = 40
SEEN = 0.3  # ratio below which an effect does not act, so that the trial is drawn again
DRAWS = 6
SOFTNESS = (
    2.0  # of the elastic part of specimens with Hertzian contacts, both with and without them
)

DEVELOPMENT = (
    ("none",),
    ("none",),
    ("single", "bond_ageing"),
    ("single", "wall_friction"),
    ("single", "platen_compliance"),
    ("single", "hertzian_contact"),
    ("single", "contact_plasticity"),
    ("single", "wetting_collapse"),
    ("single", "instrument_drift"),
    ("pair", "bond_ageing", "wall_friction"),
    ("outside", "pore_water"),
    ("weak", "bond_ageing"),
)
SEALED = (
    *[("none",)] * 10,
    *[("single", name) for name in effects.INSIDE for _ in range(3)],
    ("pair", "bond_ageing", "wall_friction"),
    ("pair", "bond_ageing", "hertzian_contact"),
    ("pair", "bond_ageing", "platen_compliance"),
    ("pair", "bond_ageing", "instrument_drift"),
    ("pair", "wall_friction", "platen_compliance"),
    ("pair", "wall_friction", "wetting_collapse"),
    ("pair", "wetting_collapse", "instrument_drift"),
    ("pair", "contact_plasticity", "wetting_collapse"),
    *[("outside", name) for name in effects.OUTSIDE],
    ("outside", "pore_water"),
    ("outside", "swelling"),
    ("outside", "healing"),
    ("weak", "bond_ageing"),
    ("weak", "wall_friction"),
    ("weak", "platen_compliance"),
    ("weak", "wetting_collapse"),
    ("weak", "loading_too_fast"),
    ("weak", "instrument_drift"),
    ("poor", "bond_ageing"),
    ("poor", "hertzian_contact"),
    ("poor",),
)
# Shown to the reader: creep in four holds, with drift and noise, stages unlabelled.
DEMONSTRATION = Trial(
    "single",
    "creep",
    effects.draw_base(np.random.default_rng(1)),
    {"bond_ageing": {"delayed": 4e-4, "delayed_power": 1.8, "delayed_time": 0.3}},
    ("ae_events",),
    Concealment(microns=1.0, stress=0.002, drift=2e-5, labelled=False, ramp=24, hold=28),
    seed=4,
)
PROGRAMS = {
    "development": ("steps", "long-hold", "loops"),
    "sealed": ("steps", "long-hold", "loops", "small", "high"),
}


def concealment(rng: np.random.Generator, poor: bool = False, drifts: bool = True) -> Concealment:
    """A grade of concealment."""
    kind = rng.random()
    if kind < 0.6:
        noise = {"microns": round(float(0.4 * 8 ** rng.random()), 2)}
    else:
        noise = {"microns": 0.3, "relative": round(float(0.005 * 10 ** (rng.random() ** 1.5)), 4)}
    return Concealment(
        **noise,
        stress=round(float(0.001 * 4 ** rng.random()), 4),
        drift=round(float(2e-5 * rng.standard_normal()), 7)
        if drifts and rng.random() < 0.25
        else 0,
        labelled=bool(rng.random() < 0.4) and not poor,
        timed=bool(rng.random() < 0.85) and not poor,
        ramp=int(rng.integers(14, 36)),
        hold=int(rng.integers(14, 36)),
    )


def trials(kind: str, seed: int) -> Iterator[Trial]:
    """Those of DEVELOPMENT or SEALED."""
    for number, (grade, *names) in enumerate({"development": DEVELOPMENT, "sealed": SEALED}[kind]):
        rng = np.random.default_rng([seed, number])
        for _ in range(DRAWS):
            trial = sized(_drawn(grade, tuple(names), PROGRAMS[kind], rng))
            # Some effects need breakage, which a strong specimen may not have.
            if all(found["ratio"] > SEEN for found in ratios(trial, effects)[1].values()):
                break
        yield trial


def _drawn(
    grade: str, names: tuple[str, ...], programs: tuple[str, ...], rng: np.random.Generator
) -> Trial:
    program = "ramp" if grade == "poor" else str(rng.choice(programs))
    drifts = not {"instrument_drift", "load_leak", "swelling", "thermal_strain"} & set(names)
    how = concealment(rng, grade == "poor", drifts)
    base = effects.draw_base(rng)
    if "hertzian_contact" in names:
        base["softness"] = SOFTNESS
    likely = 0.55 if "wall_friction" in names else 0.25
    channels = ("base_stress",) * (rng.random() < likely) + ("ae_events",) * (rng.random() < 0.4)
    acting = {name: effects.draw(name, program, rng) for name in names}
    return Trial(grade, program, base, acting, channels, how, int(rng.integers(1, 10_000)))


def sized(trial: Trial) -> Trial:
    """The trial with each effect made larger until it is what its grade says, or smaller in weak ones, within reason."""
    if trial.grade == "poor":
        return trial
    for name in trial.effects:
        for _ in range(TRIES):
            found = ratios(trial, effects)[1][name]
            if trial.grade == "weak":
                factor = 1 / GROWTH if found["ratio"] > WEAK else 0
            else:
                twin = name in effects.TWINS
                ratio = found["ratio" if twin else "ratio_beyond_calibration"]
                factor = GROWTH if ratio < STRONG else 0
            changed = effects.scaled(name, trial.effects[name], factor) if factor else None
            if changed is None:
                break
            trial = replace(trial, effects={**trial.effects, name: changed})
    return trial
