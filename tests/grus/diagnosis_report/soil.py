"""A soil of three lines that stands for the DEM: a whole diagnosis in seconds.

It creeps when bonds age, breaks more when bonds are weak, and carries less to the base when walls rub.
"""

import sys
from pathlib import Path

import numpy as np

from grus.diagnosis import diagnose
from grus.diagnosis.simulator import Simulator, Test
from grus.diagnosis.verdict import Decision
from grus.record import Record, Segment

CARD = Path(__file__).resolve().parents[3] / "models" / "quick.toml"
STAGES = [
    "load to 200 kPa in 1 h",
    "hold for 4 h",
    "load to 500 kPa in 1 h",
    "hold for 80 h",
    "unload to 50 kPa in 30 min",
    "hold for 20 h",
    "load to 500 kPa in 30 min",
    "hold for 20 h",
]
AGEING = Decision("named", ("bond_ageing",), {"bond_ageing": 0.995, "wall_friction": 0.04})

MODULUS = 1e9
STEPS = 60
MORE_BROKEN = {
    "rolling_resistance": -0.3,
    "contact_plasticity": 0.2,
    "strength_scatter": 0.15,
    "loading_too_fast": -0.1,
    "wetting_collapse": 0.4,
}
"""What mechanisms do to first loading, whatever their size."""


class Soil(Simulator):
    """Simulator whose runs are formulas; the folder of the store stays empty."""

    def run(self, tests, what):
        tests = list(dict.fromkeys(tests))
        self.say(f"{what}: {len(tests)} of {len(tests)} runs")
        return {test: self._written(test, deformed(self.card, test)) for test in tests}


def without_dem(patch):
    """Formulas instead of the DEM, and a verdict that no threshold changes: the report is tested, not the statistics."""
    module = sys.modules[diagnose.__module__]
    patch.setattr(module, "Simulator", Soil)
    patch.setattr(module, "decide", lambda *found: AGEING)


def deformed(card, test: Test) -> Record:
    """What a laboratory would write down of the stages of a card."""
    on = {name: dict(values) for name, values in test.mechanisms}
    scatter = np.random.default_rng(test.seed).normal(0, [0.1, 0.3])
    stress, time, kinds = _path(card)
    elastic = stress / MODULUS / test.base.stiffness * np.exp(0.3 * scatter[0])
    strength = np.inf if test.base.strength is None else 2 ** ((test.base.strength - 5) / 2)
    peak = np.maximum.accumulate(stress)
    broken = 3e-4 * (peak / 5e5 / strength) ** 2 * np.exp(scatter[1])
    creep = np.zeros_like(stress)
    if "bond_ageing" in on:
        creep = _creep(stress, time, kinds, on["bond_ageing"].get("reference_time", 1e5))
    for name, share in MORE_BROKEN.items():
        broken *= 1 + share * (name in on)
    if "hertzian_contact" in on:
        elastic *= (stress / stress.max()) ** (-1 / 3)
    rubbing = on.get("wall_friction", {}).get("coefficient", 0.0)
    channels = {
        "time": time,
        "axial_stress": stress,
        "axial_strain": (elastic + broken) * (1 - 0.5 * rubbing) + creep,
        "base_stress": stress * (1 - 0.8 * rubbing),
        "lateral_stress": 0.5 * stress,
    }
    units = {
        "time": "s",
        "axial_stress": "Pa",
        "axial_strain": "1",
        "base_stress": "Pa",
        "lateral_stress": "Pa",
    }
    return Record(channels, units, {"height": 0.05}, _segments(stress, time, kinds))


def _path(card):
    """Stress and time (n,) at the readings, and the kind of each stage, the seating first."""
    level, now = 5e3, 0.0
    stresses, times, kinds = [np.full(STEPS, level)], [np.zeros(STEPS)], ["seat"]
    for stage in card.oedometer.stages:
        goal = float(stage.stress) if stage.stress else level
        lasts = float(stage.duration or 60.0)
        stresses.append(np.linspace(level, goal, STEPS))
        share = np.linspace(0, 1, STEPS)
        # As many readings a decade of time in a hold.
        share = np.concatenate([[0], np.geomspace(1e-4, 1, STEPS - 1)]) if goal == level else share
        times.append(now + lasts * share)
        kinds.append({"wet": "hold"}.get(stage.kind, stage.kind))
        level, now = goal, now + lasts
    return np.concatenate(stresses), np.concatenate(times), kinds


def _creep(stress, time, kinds, reference):
    rate = 2e-4 * (1e5 / reference) ** 0.25
    creep, level = np.zeros_like(stress), 0.0
    for number, kind in enumerate(kinds):
        rows = slice(number * STEPS, (number + 1) * STEPS)
        creep[rows] = level
        # Less stress than before stops it, and what was held before goes on slowly.
        if kind == "hold" and stress[rows][0] >= stress.max() * 0.3:
            since = time[rows] - time[rows][0]
            again = (
                0.4
                if number > 1 and stress[rows][0] <= stress[: number * STEPS - STEPS].max()
                else 1.0
            )
            creep[rows] += again * rate * (stress[rows] / 5e5) ** 2 * np.log10(1 + since / 60)
            level = creep[rows][-1]
    return creep


def _segments(stress, time, kinds):
    found, highest = [], 0.0
    for number, kind in enumerate(kinds):
        first, last = number * STEPS, (number + 1) * STEPS - 1
        ends = float(stress[first]), float(stress[last])
        kind = "reload" if kind == "load" and ends[1] <= highest else kind
        highest = max(highest, *ends)
        found.append(
            Segment(kind, number, first, last, float(time[first]), float(time[last]), *ends)
        )
    return tuple(found)
