"""Size effect: how the characteristic strength depends on the grain diameter."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.stats import chi2

from grus.errors import GrusError
from grus.statistics.sample import relative_logs
from grus.statistics.size_regression import SizeRegression
from grus.statistics.weibull import WeibullFit, fit_weibull


@dataclass(frozen=True)
class SizeEffect:
    """Joint fit of all sizes with one modulus m.

    sigma0 = reference_strength * (d / reference_diameter)^slope.

    Strengths share one unit, diameters another (Pa and m inside Grus). Intervals are (low, high) by
    profile likelihood at the given confidence.
    """

    dimension: int
    """2 or 3: the dimension of the grains."""
    n: int
    """Number of grains of all sizes."""
    modulus: float
    """Weibull modulus common to all sizes."""
    modulus_ci: tuple[float, float]
    slope: float
    """Exponent b of sigma0 ~ d^b as fitted."""
    slope_ci: tuple[float, float]
    expected_slope: float
    """-dimension / modulus: what a Weibull law over the volume of the grain predicts."""
    expected_slope_ci: tuple[float, float]
    """From the interval of the common modulus."""
    agreement_p_value: float
    """Likelihood-ratio test of slope = -dimension / modulus against a free slope
    (chi-square, 1)."""
    model_p_value: float
    """Likelihood-ratio test of this joint fit against a separate Weibull law for each size
    (chi-square, 2 k - 3 for k sizes); small when the modulus or the power law fails."""
    reference_diameter: float
    """Geometric mean diameter of the broken grains."""
    reference_strength: float
    """Characteristic strength at the reference diameter."""
    confidence: float
    diameters: tuple[float, ...]
    fits: tuple[WeibullFit, ...]
    """Separate fit of each size, in the order of ``diameters``."""

    def strength(self, diameter) -> np.ndarray:
        """Characteristic strength of the joint fit at the given diameters, any shape."""
        return self.reference_strength * np.power(
            np.divide(diameter, self.reference_diameter), self.slope
        )


def size_effect(
    diameters: Sequence[float],
    groups: Sequence[WeibullFit | Sequence[float]],
    dimension: int,
    confidence: float = 0.95,
    seed: int = 0,
) -> SizeEffect:
    """Weibull regression ln sigma0 = a + b ln d with a common modulus, by maximum likelihood.

    diameters: (k,) one per size. groups: (k,) fits (for censored groups) or strengths of each size;
    strengths are fitted with ``confidence`` and ``seed`` first. dimension: 2 or 3.

    Survival of a grain of volume ~ d^dim under exp(-(V/V0) (s/s0)^m) gives sigma0 ~ d^(-dim/m)
    (Weibull 1951; McDowell & Bolton 1998, Geotechnique 48:667-679). Intervals and tests are
    asymptotic: with fewer than about 30 grains in all they are a little too sharp.

    Raises GrusError for fewer than two sizes, diameters that are not positive, another dimension,
    fits of another confidence, and groups that ``fit_weibull`` refuses.
    """
    sizes = _checked_diameters(diameters, len(groups))
    if dimension not in (2, 3):
        raise GrusError(f"dimension: {dimension!r}; must be 2 or 3")
    fits = tuple(
        group if isinstance(group, WeibullFit) else fit_weibull(group, confidence, seed)
        for group in groups
    )
    levels = {fit.confidence for fit in fits} - {confidence}
    if levels:
        raise GrusError(
            f"groups: fit of confidence {levels.pop()}; must be {confidence}, as asked for"
        )
    strengths = np.concatenate([fit.strengths for fit in fits])
    broken = ~np.concatenate([fit.censored for fit in fits])
    log_diameters = np.repeat(np.log(sizes), [fit.n for fit in fits])
    centre = log_diameters[broken].mean()
    regression = SizeRegression(relative_logs(strengths), broken, log_diameters - centre)
    allowed = 0.5 * chi2.ppf(confidence, 1)
    low, high = regression.modulus_interval(allowed)
    # the separate fits count the density of strength, the regression that of its logarithm
    separate = sum(fit.log_likelihood for fit in fits) + np.log(strengths[broken]).sum()
    return SizeEffect(
        dimension=int(dimension),
        n=int(strengths.size),
        modulus=regression.modulus,
        modulus_ci=(low, high),
        slope=regression.slope,
        slope_ci=regression.slope_interval(allowed),
        expected_slope=-dimension / regression.modulus,
        expected_slope_ci=(-dimension / low, -dimension / high),
        agreement_p_value=_ratio_test(regression.peak, regression.constrained(dimension), 1),
        model_p_value=_ratio_test(separate, regression.peak, 2 * sizes.size - 3),
        reference_diameter=float(np.exp(centre)),
        reference_strength=float(strengths.max() * np.exp(regression.location)),
        confidence=float(confidence),
        diameters=tuple(sizes.tolist()),
        fits=fits,
    )


def _ratio_test(free: float, constrained: float, freedom: int) -> float:
    return float(chi2.sf(2.0 * max(free - constrained, 0.0), freedom))


def _checked_diameters(diameters: Sequence[float], count: int) -> np.ndarray:
    sizes = np.asarray(diameters, dtype=float)
    if sizes.ndim != 1 or sizes.size != count:
        raise GrusError(f"diameters: shape {sizes.shape} for {count} groups; must be one per group")
    bad = np.flatnonzero(~(np.isfinite(sizes) & (sizes > 0)))
    if bad.size:
        raise GrusError(
            f"diameters: value {sizes[bad[0]]:g} at index {bad[0]}; must be positive and finite"
        )
    if np.unique(sizes).size < 2:
        raise GrusError(f"diameters: {sizes.tolist()}; a size effect needs at least two sizes")
    return sizes
