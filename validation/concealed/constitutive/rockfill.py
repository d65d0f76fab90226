"""Rockfill in an oedometer after Oldecop & Alonso, with specimens that scatter as small ones do.

Immediate strain grows linearly with stress below a yield stress and more steeply above it, a delayed strain grows with the
logarithm of time, and wetting adds what the wet material would have strained more (Oldecop & Alonso 2001, Geotechnique
51:127-139; 2007, Geotechnique 57:289-301). Elastic strain recovers, with a loop from sliding. Breakage is a sum of jumps, since a
small specimen has few grains to break.
"""

from dataclasses import dataclass, replace

import numpy as np

REFERENCE = 100.0  # stress that compressibilities are given for [kPa]
RESOLUTION = 0.5  # stress between two possible jumps [kPa]
GRID = np.arange(0, 2500, RESOLUTION)  # stresses of the table of jumps [kPa]
LATE = np.arange(4001) * 2e-5  # delayed strains of its table of jumps [1]
SWELLING_TIME = 8.0  # [h]
SMALL = 0.3  # jumps of delayed breakage over those of loading
EVENTS = 12  # bonds lost in a mean jump
PLAYS = np.geomspace(8, 250, 12)  # half widths of the sliding elements [kPa]


@dataclass(frozen=True)
class Rockfill:
    """Material: strains per 100 kPa [1], stresses [kPa], times [h].

    Effects are off by default: exponent 1 is linear elasticity, plasticity 1 unloads as it loads.
    """

    elastic: float = 4e-4
    rearrangement: float = 1.6e-4  # first loading only, at once
    sliding: float = 1.2e-4  # loop of sliding contacts
    breakage: float = 9e-4  # beyond the yield stress
    yield_stress: float = 330.0
    jump: float = 1.5e-4  # mean strain of one grain that breaks [1]
    exponent: float = 1.0  # of the elastic strain in stress; 2/3 for Hertzian contacts
    plasticity: float = 1.0  # stiffness of unloading over that of loading, of the elastic strain
    spread: float = 0.0  # of yield stresses inside the specimen, as coefficient of variation [1]
    delayed: float = 0.0  # strain in an e-fold of time at the yield stress [1]
    delayed_power: float = 2.0  # of the stress, of the delayed strain
    delayed_time: float = 0.3  # after which delay sets in [h]
    collapse: float = 0.0  # strength lost on wetting, as a share of the yield stress [1]
    collapse_at: float = np.inf  # [h]
    collapse_time: float = 0.1  # wetting takes this long [h]
    healing: float = 0.0  # rise of the yield stress in an e-fold of time at rest, as a share [1]
    swelling: float = 0.0  # strain that comes back in the end when all load is off [1]


def specimen(material: Rockfill, rng: np.random.Generator) -> Rockfill:
    """One specimen of the material: what differs from seed to seed."""

    def around(value: float, deviation: float) -> float:
        return value * float(np.exp(deviation * rng.standard_normal()))

    return replace(
        material,
        elastic=around(material.elastic, 0.06),
        rearrangement=around(material.rearrangement, 0.3),
        sliding=around(material.sliding, 0.2),
        breakage=around(material.breakage, 0.3),
        yield_stress=around(material.yield_stress, 0.12),
    )


class Layer:
    """State of a specimen, or of one layer of it, under a stress that the caller drives."""

    def __init__(self, material: Rockfill, rng: np.random.Generator, stress: float):
        self.material = material
        self.stress = self.highest = stress
        self.plays = np.full(len(PLAYS), stress)
        # Jumps of breakage along the stress that breaks, and along the delayed strain: gamma processes of mean 1.
        step = self._breakage_density(GRID[:-1]) * RESOLUTION / REFERENCE
        shape = np.maximum(step / material.jump, 1e-12)
        self._broken = np.r_[0, np.cumsum(rng.gamma(shape) * material.jump)]
        shape = np.full(len(LATE) - 1, LATE[1] / (SMALL * material.jump))
        self._late = np.r_[0, np.cumsum(rng.gamma(shape) * SMALL * material.jump)]
        self.delayed = 0.0
        self.shift = 1.0  # of the yield stress, by wetting and healing
        self.swollen = 0.0
        self._reached = 0.0
        self._zero = 0.0
        self._zero = self.strain()

    def _breakage_density(self, stress: np.ndarray) -> np.ndarray:
        """Strain per 100 kPa by breakage at a stress: sharp, or spread as a Weibull distribution of strengths."""
        material = self.material
        if not material.spread:
            return material.breakage * (stress > material.yield_stress)
        modulus = material.spread**-1.086
        return material.breakage * -np.expm1(-((stress / material.yield_stress) ** modulus))

    def advance(self, stress: float, hours: float, time: float) -> float:
        """Strain [1] after `hours` in which the stress became `stress`; `time` is the clock at their end [h]."""
        material = self.material
        self.stress = stress
        self.highest = max(self.highest, stress)
        self.plays = np.clip(self.plays, stress - PLAYS, stress + PLAYS)
        if material.collapse and time > material.collapse_at:
            wet = -np.expm1(-(time - material.collapse_at) / material.collapse_time)
            self.shift = 1 - material.collapse * wet
        self._age(hours)
        self._heal(hours)
        # The stress that breakage has reached, in terms of the dry material that never rested.
        self._reached = max(self._reached, stress / self.shift)
        self._swell(hours)
        return self.strain()

    def _age(self, hours: float) -> None:
        """Delayed strain: its rate falls by e for each `delayed`-part of strain, and rises with what loading adds."""
        material = self.material
        if not material.delayed or self.stress < 0.3 * material.yield_stress:
            return
        scale = material.delayed * (self.stress / material.yield_stress) ** material.delayed_power
        ahead = self.delayed - self._drive()
        # Exact for constant stress: d(delayed)/dt = scale/tau exp(-ahead/scale).
        self.delayed += scale * np.log1p(hours / material.delayed_time * np.exp(-ahead / scale))

    def _drive(self) -> float:
        """Delayed strain at which the rate is that of a load just put on [1]."""
        material = self.material
        reached = material.delayed_power * material.delayed * 3
        share = self.stress / material.yield_stress
        return reached * (share**material.delayed_power - 0.3**material.delayed_power)

    def _heal(self, hours: float) -> None:
        material = self.material
        if material.healing:
            age = (self.shift - 1) / material.healing
            self.shift = 1 + material.healing * np.log(np.exp(age) + hours / 1.0)

    def _swell(self, hours: float) -> None:
        material = self.material
        if not material.swelling:
            return
        aim = material.swelling * (1 - self.stress / self.highest)
        self.swollen += (aim - self.swollen) * -np.expm1(-hours / SWELLING_TIME)

    def strain(self) -> float:
        material = self.material
        # The same at 400 kPa whatever the exponent.
        now = 4 * material.elastic * (self.stress / (4 * REFERENCE)) ** material.exponent
        top = 4 * material.elastic * (self.highest / (4 * REFERENCE)) ** material.exponent
        now = now / material.plasticity + top * (1 - 1 / material.plasticity)
        slid = material.sliding / REFERENCE * float(self.plays.mean())
        packed = material.rearrangement / REFERENCE * self.highest
        broken = float(np.interp(self._reached, GRID, self._broken))
        late = float(np.interp(self.delayed, LATE, self._late))
        return now + slid + packed + broken + late - self.swollen - self._zero

    def events(self) -> float:
        """Bonds lost so far [1]."""
        broken = float(np.interp(self._reached, GRID, self._broken))
        late = float(np.interp(self.delayed, LATE, self._late))
        return EVENTS * (broken + late) / self.material.jump
