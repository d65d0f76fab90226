"""Two-parameter Weibull law of crushing strengths."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from grus.errors import GrusError
from grus.statistics.anderson_darling import anderson_darling
from grus.statistics.likelihood import log_likelihood, maximum_likelihood
from grus.statistics.likelihood_region import LikelihoodRegion
from grus.statistics.pivots import PivotalIntervals, simulate_pivots
from grus.statistics.sample import StrengthSample, strength_sample


@dataclass(frozen=True)
class WeibullFit:
    """Maximum-likelihood fit of P_s = exp(-(strength / sigma0)^modulus).

    Strengths, ``sigma0`` and ``sigma0_ci`` share the unit of the input (Pa inside Grus); the rest
    is dimensionless. Intervals are (low, high) at the given confidence.
    """

    n: int
    """Number of grains, broken or not."""
    broken: int
    """Number of grains that broke."""
    modulus: float
    """Weibull modulus m, maximum likelihood (biased upwards in small groups)."""
    modulus_ci: tuple[float, float]
    modulus_unbiased: float | None
    """m divided by the mean of m^/m for this n; None for censored groups. In groups of three or
    four the mean itself is known to a few per cent only."""
    sigma0: float
    """Characteristic strength: 37 % of the grains survive it."""
    sigma0_ci: tuple[float, float]
    log_likelihood: float
    """Of the strengths in their unit; a change of unit shifts it by a constant."""
    anderson_darling: float | None
    """A^2 distance to the fitted law; None for censored groups."""
    p_value: float | None
    """Probability of a larger A^2 if the law holds; None for censored groups."""
    confidence: float
    seed: int
    strengths: tuple[float, ...] = field(repr=False)
    censored: tuple[bool, ...] = field(repr=False)

    def survival(self, strength) -> np.ndarray:
        """Survival probability at the given strengths, any shape."""
        return np.exp(-np.exp(self.modulus * np.log(np.divide(strength, self.sigma0))))

    def strength(self, survival) -> np.ndarray:
        """Strength that the given shares (0..1) of the grains survive, any shape."""
        return self.sigma0 * np.exp(_reduced(survival) / self.modulus)

    def strength_interval(self, survival) -> tuple[np.ndarray, np.ndarray]:
        """Pointwise confidence interval (low, high) of ``strength(survival)``; survival (k,)."""
        sample = strength_sample(self.strengths, self.censored)
        location = np.log(self.sigma0 / sample.largest)
        intervals = _intervals(sample, self.modulus, location, self.confidence, self.seed)
        low, high = intervals.quantile_interval(np.atleast_1d(_reduced(survival)))
        return _unscaled(sample, low), _unscaled(sample, high)


def fit_weibull(strengths, confidence: float = 0.95, seed: int = 0, censored=None) -> WeibullFit:
    """Fit the two-parameter Weibull law (location zero) by maximum likelihood.

    strengths: (n,) positive, one unit. censored: (n,) bool, True for a grain that did not break;
    its strength is then the largest stress it carried.

    Complete groups: intervals from the pivots of Thoman, Bain & Antle (1969), valid for every n up
    to the scatter of the simulation; the p-value from the same simulation, since A^2 is free of
    parameters too. (scipy's goodness_of_fit refits each sample by a general optimiser instead.)
    Censored groups: intervals by profile likelihood ratio (chi-square, one degree of freedom),
    which is approximate for few broken grains; no goodness of fit and no unbiasing factor, because
    both would depend on the unknown limits of the grains that broke.

    Raises GrusError for bad strengths or mask (see ``strength_sample``), confidence or seed.
    """
    if not 0.0 < confidence < 1.0:
        raise GrusError(f"confidence: {confidence}; must lie between 0 and 1")
    if not isinstance(seed, (int, np.integer)) or seed < 0:
        raise GrusError(f"seed: {seed!r}; must be a whole number, zero or more")
    sample = strength_sample(strengths, censored)
    modulus, location = maximum_likelihood(sample.logs, sample.broken)
    intervals = _intervals(sample, modulus, location, confidence, seed)
    low, high = _unscaled(sample, np.ravel(intervals.quantile_interval(np.zeros(1)))).tolist()
    density = log_likelihood(sample.logs, sample.broken, modulus, location)
    unbiased = distance = p_value = None
    if sample.broken.all():
        pivots = simulate_pivots(sample.logs.size, int(seed))
        unbiased = float(modulus / pivots.modulus.mean())
        distance = float(anderson_darling(modulus * (np.sort(sample.logs) - location)))
        p_value = pivots.p_value(distance)
    return WeibullFit(
        n=sample.logs.size,
        broken=int(sample.broken.sum()),
        modulus=float(modulus),
        modulus_ci=intervals.modulus_interval(),
        modulus_unbiased=unbiased,
        sigma0=float(_unscaled(sample, location)),
        sigma0_ci=(low, high),
        log_likelihood=float(density - np.log(sample.strengths[sample.broken]).sum()),
        anderson_darling=distance,
        p_value=p_value,
        confidence=float(confidence),
        seed=int(seed),
        strengths=tuple(sample.strengths.tolist()),
        censored=tuple((~sample.broken).tolist()),
    )


def _intervals(
    sample: StrengthSample, modulus: float, location: float, confidence: float, seed: int
) -> PivotalIntervals | LikelihoodRegion:
    if sample.broken.all():
        pivots = simulate_pivots(sample.logs.size, int(seed))
        return PivotalIntervals(pivots, modulus, location, confidence)
    return LikelihoodRegion(sample.logs, sample.broken, modulus, confidence)


def _unscaled(sample: StrengthSample, logs) -> np.ndarray:
    """Strengths from logarithms relative to the largest; infinite beyond the range of floats."""
    with np.errstate(over="ignore"):
        return sample.largest * np.exp(logs)


def _reduced(survival) -> np.ndarray:
    shares = np.asarray(survival, dtype=float)
    bad = shares[~((shares > 0.0) & (shares < 1.0))]
    if bad.size:
        raise GrusError(f"survival: {bad[0]}; every share must lie between 0 and 1")
    return np.log(-np.log(shares))
