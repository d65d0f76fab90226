"""Figures of Grus: one style, drawn without a display.

Each function draws numbers that were computed elsewhere and returns a matplotlib Figure.
"""

from grus.plotting.force_displacement import force_displacement_plot
from grus.plotting.frame import draw_key, new_figure
from grus.plotting.size_effect import size_effect_plot
from grus.plotting.style import save, style
from grus.plotting.weibull import weibull_plot

__all__ = [
    "draw_key",
    "force_displacement_plot",
    "new_figure",
    "save",
    "size_effect_plot",
    "style",
    "weibull_plot",
]
