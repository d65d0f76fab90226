"""Yield of a compression curve: the bend of void ratio against the logarithm of stress."""

from dataclasses import dataclass

import numpy as np

from grus.compression.bend import sharpest_bend
from grus.compression.breaks import Breaks, find_breaks
from grus.compression.loading import loading_curve
from grus.compression.readings import Readings, bend
from grus.specimen.require import require

EXPONENTS = np.linspace(0.05, 1.0, 20)
"""Tried in Janbu's law; 0 is the straight line over the logarithm of stress."""
WIDTHS = (0.0, 0.01, 0.02, 0.03, 0.05, 0.07, 0.1, 0.15)
"""Tried for the bend, in decades of stress; linear elasticity bends three times as widely."""
REFINEMENTS = 2
POSITIVE_EVIDENCE = 2.0
"""Of the scale of Kass & Raftery (1995), who call 6 strong and 10 very strong."""


@dataclass(frozen=True)
class YieldStress:
    """Where the void ratio goes over from a flat to a steep line over log10 stress.

    stress, interval: of the point where both lines meet [Pa], the interval at that confidence.
    void_ratio: at that point.
    width: of the bend between the lines [decades of stress]; nine tenths of it lie within six
        widths; 0 is a kink.
    index_before, compression_index: fall of the void ratio for a tenfold stress, of both lines.
    sharpest_bend: stress at which the slope falls fastest [Pa], a check by other means; None when
        the smoothed curve bends nowhere.
    evidence: by how much the Bayesian information criterion is below that of the best law without
        yield.
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
        """Void ratio of the fitted curve at any stresses [Pa]."""
        decades = np.log10(np.asarray(stress, dtype=float) / self.stress)
        steeper = self.compression_index - self.index_before
        return self.void_ratio - self.index_before * decades - steeper * bend(decades, self.width)


def yield_stress(
    stress: np.ndarray, void_ratio: np.ndarray, *, seating: float = 0.0, confidence: float = 0.95
) -> YieldStress | None:
    """The yield of a compression curve, or None when a law without yield describes it as well.

    stress [Pa], void_ratio [-]: (n,) in the order of the test, unloading and holds included; only
        readings of first loading are used, those below `seating` [Pa] left out. Give one reading
        a stage for the curve that joins the ends of stages.

    Two straight lines over log10 stress, the second steeper and joined by a kink or a narrow bend,
    are compared with one law for the whole curve: a straight line, and the stiffness of Janbu
    (1963), void ratio = a - b stress^c with 0 < c <= 1, of which c = 1 is linear elasticity.
    Raises GrusError for fewer than seven readings of first loading, stresses too close to each
    other, and columns that are no equal lists of finite numbers.
    """
    require(0 < confidence < 1, "confidence", confidence, "in (0, 1)")
    stress, void_ratio = loading_curve(stress, "void_ratio", void_ratio, seating)
    curve, found = _broken_line(np.log10(stress), void_ratio, confidence)
    if not found.places:
        return None
    with_yield = found.criterion[1] + np.log(curve.count)  # for the width of the bend
    evidence = min(found.criterion[0], _janbu(curve)) - with_yield
    if evidence < POSITIVE_EVIDENCE:
        return None
    level, slopes, width = curve.slopes(found.places)
    sharpest = sharpest_bend(curve.x, curve.y)
    low, high = found.interval
    return YieldStress(
        stress=10 ** found.places[0],
        interval=(10**low, 10**high),
        void_ratio=level,
        width=width,
        index_before=float(-slopes[0]),
        compression_index=float(-slopes[1]),
        sharpest_bend=None if sharpest is None else 10**sharpest,
        evidence=float(evidence),
        confidence=float(confidence),
    )


def _broken_line(
    place: np.ndarray, void_ratio: np.ndarray, confidence: float
) -> tuple[Readings, Breaks]:
    """The best line with its break, the widths refined about the best of those tried.

    A width between two of a coarse grid would shift the place by more than the noise does.
    """
    widths = WIDTHS
    for refinement in range(1 + REFINEMENTS):
        curve = Readings(place, void_ratio, sense=-1, widths=widths)
        found = find_breaks(curve, 1, confidence)
        if not found.places or refinement == REFINEMENTS:
            break
        best = widths.index(curve.slopes(found.places)[2])
        beside = widths[max(best - 1, 0)], widths[min(best + 1, len(widths) - 1)]
        widths = tuple(np.union1d(WIDTHS, [widths[best], *np.linspace(*beside, 7)]).tolist())
    return curve, found


def _janbu(curve: Readings) -> float:
    """Criterion of the best void ratio = a - b stress^c."""
    ratio = curve.x - curve.x[-1]
    bases = (np.stack([np.ones(curve.count), 10 ** (c * ratio)], axis=1) for c in EXPONENTS)
    return min(curve.deviance(basis) for basis in bases) + 3 * np.log(curve.count)
