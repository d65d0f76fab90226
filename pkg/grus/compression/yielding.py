"""Yield of a compression curve: the kink of void ratio against the logarithm of stress."""

from dataclasses import dataclass

import numpy as np

from grus.compression.bend import sharpest_bend
from grus.compression.breaks import find_breaks
from grus.compression.loading import loading_curve
from grus.compression.readings import Readings
from grus.specimen.require import require

EXPONENTS = np.linspace(0.05, 1.0, 20)
"""Tried in Janbu's law; 0 is the straight line over the logarithm of stress."""

WIDTHS = (0.0, 0.02, 0.05, 0.1, 0.15)
"""Of the bend, in decades of stress; elastic compression bends over three times the widest."""
NEEDED = 0.0


@dataclass(frozen=True)
class YieldStress:
    """A kink from a flat to a steep line of void ratio over log10 stress.

    stress, interval: of the kink [Pa], the interval at the given confidence.
    void_ratio: on both lines at the kink.
    index_before, compression_index: fall of the void ratio for a tenfold stress, of both lines.
    sharpest_bend: stress of the largest curvature [Pa], a check by other means; None when the
        smoothed curve bends nowhere.
    evidence: by how much the Bayesian information criterion of the kink is below that of the best
        law without one; above 10 it is strong.
    """

    stress: float
    interval: tuple[float, float]
    void_ratio: float
    width: float
    index_before: float
    compression_index: float
    sharpest_bend: float | None
    evidence: float
    confidence: float

    def line(self, stress: np.ndarray) -> np.ndarray:
        """Void ratio of the two lines at any stresses [Pa]."""
        decades = np.log10(np.asarray(stress, dtype=float) / self.stress)
        index = np.where(decades < 0, self.index_before, self.compression_index)
        return self.void_ratio - index * decades


def yield_stress(
    stress: np.ndarray, void_ratio: np.ndarray, *, seating: float = 0.0, confidence: float = 0.95
) -> YieldStress | None:
    """The kink of a compression curve, or None when a law without yield describes it as well.

    stress [Pa], void_ratio [-]: (n,) in the order of the test, unloading and holds included; only
        readings of first loading are used, those below `seating` [Pa] left out.

    Two straight lines over log10 stress, the second steeper, are compared with one law for the whole
    curve: a straight line, and the stiffness of Janbu (1963), void ratio = a - b stress^c with
    0 < c <= 1, of which c = 1 is linear elasticity. Raises GrusError for fewer than seven readings
    of first loading and for columns that are no equal lists of finite numbers.
    """
    require(0 < confidence < 1, "confidence", confidence, "in (0, 1)")
    place, value = loading_curve(stress, "void_ratio", void_ratio, seating)
    curve = Readings(place, value, sense=-1, widths=WIDTHS)
    found = find_breaks(curve, 1, confidence)
    if not found.places:
        return None
    price = np.log(curve.count)
    evidence = min(found.criterion[0], _janbu(curve)) - (found.criterion[1] + price)
    if evidence <= NEEDED:
        return None
    level, slopes, width = curve.slopes(found.places)
    bend = sharpest_bend(curve.x, curve.y)
    low, high = found.interval
    return YieldStress(
        stress=10 ** found.places[0],
        interval=(10**low, 10**high),
        void_ratio=level,
        width=width,
        index_before=float(-slopes[0]),
        compression_index=float(-slopes[1]),
        sharpest_bend=None if bend is None else 10**bend,
        evidence=float(evidence),
        confidence=float(confidence),
    )


def _janbu(curve: Readings) -> float:
    """Criterion of the best void ratio = a - b stress^c."""
    ratio = curve.x - curve.x[-1]
    bases = (np.stack([np.ones(curve.count), 10 ** (c * ratio)], axis=1) for c in EXPONENTS)
    return min(curve.deviance(basis) for basis in bases) + 3 * np.log(curve.count)
