"""Survival probability of the grains of a group, by mean ranks."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from grus.statistics.sample import strength_sample


@dataclass(frozen=True)
class SurvivalPoints:
    """Points of the broken grains of a group, weakest first.

    strength: (k,) in the unit of the input. survival: (k,) mean-rank survival probability.
    """

    strength: np.ndarray
    survival: np.ndarray

    @property
    def abscissa(self) -> np.ndarray:
        """ln(strength), (k,): abscissa of the linearised Weibull plot."""
        return np.log(self.strength)

    @property
    def ordinate(self) -> np.ndarray:
        """ln(ln(1/P_s)), (k,): ordinate of the linearised Weibull plot, slope m."""
        return np.log(-np.log(self.survival))


def survival_points(strengths, censored=None) -> SurvivalPoints:
    """Survival probability P_s = 1 - i/(n+1) of each broken grain.

    strengths: (n,) positive. censored: (n,) bool, True for grains that did not break; they have no
    point of their own, but raise the ranks of the stronger grains (adjusted ranks of Johnson 1964,
    The Statistical Treatment of Fatigue Experiments). At equal strength broken grains come first.

    Raises GrusError for the samples that ``fit_weibull`` refuses.
    """
    sample = strength_sample(strengths, censored)
    order = np.lexsort((~sample.broken, sample.strengths))
    broken = sample.broken[order]
    n = order.size
    ranks = np.empty(n)
    rank = 0.0
    for position in range(n):
        if broken[position]:
            # what is left of the rank scale, shared by the grains not yet passed
            rank += (n + 1 - rank) / (n + 1 - position)
        ranks[position] = rank
    return SurvivalPoints(sample.strengths[order][broken], 1.0 - ranks[broken] / (n + 1))
