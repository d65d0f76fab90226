"""Statistics of crushing strengths: Weibull law, survival probability, size effect.

Pure functions of numbers; nothing here needs YADE.
"""

from grus.statistics.size_effect import SizeEffect, size_effect
from grus.statistics.survival import SurvivalPoints, survival_points
from grus.statistics.weibull import WeibullFit, fit_weibull

__all__ = [
    "SizeEffect",
    "SurvivalPoints",
    "WeibullFit",
    "fit_weibull",
    "size_effect",
    "survival_points",
]
