"""Onset of sustained breakage: where it begins to grow steadily with the logarithm of stress."""

from dataclasses import dataclass

import numpy as np

from grus.compression.breaks import find_breaks
from grus.compression.counts import Counts
from grus.compression.loading import loading_curve
from grus.compression.readings import Readings
from grus.specimen.require import require


@dataclass(frozen=True)
class BreakageOnset:
    """First breakage, and the stress from which breakage grows linearly with log10 stress.

    first_break: stress of the first reading with breakage [Pa], None without any (or when readings
        fall in between, so that a reading above zero proves nothing).
    first_interval: stresses of the readings between which it happened [Pa].
    stress, interval: onset of sustained breakage [Pa], at the given confidence; None when breakage
        does not turn steeper anywhere.
    broken, rate: breakage at the onset, and its growth for a tenfold stress from there on.
    rate_before: the same just before the onset.
    evidence: by how much the Bayesian information criterion is below that without an onset.
    """

    first_break: float | None
    first_interval: tuple[float, float] | None
    stress: float | None
    interval: tuple[float, float] | None
    broken: float | None
    rate: float | None
    rate_before: float | None
    evidence: float
    confidence: float

    def line(self, stress: np.ndarray) -> np.ndarray:
        """Breakage of the sustained line at stresses [Pa] from the onset on; GrusError if none."""
        require(self.stress is not None, "onset", None, "found, to have a line")
        return self.broken + self.rate * np.log10(np.asarray(stress, dtype=float) / self.stress)


def breakage_onset(
    stress: np.ndarray, broken: np.ndarray, *, seating: float = 0.0, confidence: float = 0.95
) -> BreakageOnset:
    """Onset of sustained breakage, with first breakage.

    stress [Pa], broken (number or share of broken bonds, or any measure of breakage): (n,) in the
        order of the test, unloading and holds included; only readings of first loading are used,
        those below `seating` [Pa] left out.

    Lines over log10 stress with no, one or two breaks are compared; the onset is the last break, at
    which breakage must turn steeper. A measure that is never negative and never falls is taken for
    a count of events, with Poisson's noise and a dispersion; others for readings with noise.
    Raises GrusError as `yield_stress`.
    """
    require(0 < confidence < 1, "confidence", confidence, "in (0, 1)")
    stress, broken = loading_curve(stress, "broken", broken, seating)
    counted = bool(broken[0] >= 0 and (np.diff(broken) >= 0).all())
    first, between = _first_break(stress, broken) if counted else (None, None)
    if counted and broken[-1] == broken[0]:
        return BreakageOnset(first, between, None, None, None, None, None, 0.0, confidence)
    place = np.log10(stress)
    curve = Counts(place, broken) if counted else Readings(place, broken, sense=1)
    found = find_breaks(curve, 2, confidence)
    evidence = found.criterion[0] - min(found.criterion)
    if not found.places:
        return BreakageOnset(first, between, None, None, None, None, None, evidence, confidence)
    level, rates, _ = curve.slopes(found.places)
    low, high = found.interval
    return BreakageOnset(
        first_break=first,
        first_interval=between,
        stress=10 ** found.places[-1],
        interval=(10**low, 10**high),
        broken=level,
        rate=float(rates[-1]),
        rate_before=float(rates[-2]),
        evidence=float(evidence),
        confidence=float(confidence),
    )


def _first_break(
    stress: np.ndarray, broken: np.ndarray
) -> tuple[float | None, tuple[float, float] | None]:
    some = np.flatnonzero(broken > 0)
    if not len(some):
        return None, None
    at = int(some[0])
    return float(stress[at]), (float(stress[at - 1]) if at else 0.0, float(stress[at]))
