"""Numbers as readers see them in figures: prefixes, digits, ticks of logarithmic axes."""

from __future__ import annotations

import numpy as np
from matplotlib.ticker import MaxNLocator

MEGA = 1e-6
"""Pa to MPa."""
MILLI = 1e3
"""m to mm."""

_PREFIXES = ((1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n"))
# per cent, in the order in which ticks are kept when room is short; 37 stands for 100/e
_SURVIVAL = (37, 90, 1, 99, 10, 50, 99.9, 0.1, 95, 5, 99.99, 0.01, 80, 20, 70, 60, 30)
_LOG_STEPS = ((1.0,), (1.0, 3.0), (1.0, 2.0, 5.0), (1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0))


def prefixed(largest: float, unit: str) -> tuple[float, str]:
    """Factor from SI and unit with prefix that put ``largest`` (SI, positive) into 1..1000."""
    for size, prefix in _PREFIXES:
        if largest >= size:
            return 1.0 / size, prefix + unit
    return 1.0, unit


def significant(value: float, digits: int = 3) -> str:
    """``value`` with so many significant digits; an exponent only outside 1e-4..1e6."""
    if not np.isfinite(value) or value == 0.0 or not 1e-4 <= abs(value) < 1e6:
        return f"{value:.{digits - 1}e}" if np.isfinite(value) and value else f"{value:g}"
    rounded = float(f"{value:.{digits - 1}e}")
    places = digits - 1 - int(np.floor(np.log10(abs(rounded))))
    return f"{rounded:.{max(places, 0)}f}".replace("-", "\N{MINUS SIGN}")


def interval(low: float, high: float) -> str:
    """An interval in the manner of "2.31 to 3.05"."""
    return f"{significant(low)} to {significant(high)}"


def probability(value: float) -> str:
    """A p-value in the manner of "p = 0.25", or "p < 0.001"."""
    return f"$p$ = {value:.2g}" if value >= 0.001 else "$p$ < 0.001"


def log_ticks(low: float, high: float) -> np.ndarray:
    """Round tick values between the positive limits of a logarithmic axis, four to nine of them."""
    decades = np.arange(np.floor(np.log10(low)), np.ceil(np.log10(high)) + 1)
    for steps in _LOG_STEPS:
        ticks = np.outer(10.0**decades, steps).ravel()
        ticks = ticks[(ticks >= low) & (ticks <= high)]
        if ticks.size >= 4:
            return ticks[:: 1 + (ticks.size - 1) // 8]
    ticks = MaxNLocator(nbins=6, steps=[1, 2, 2.5, 5, 10]).tick_values(low, high)
    return ticks[(ticks >= low) & (ticks <= high)]


def survival_ticks(bottom: float, top: float) -> tuple[list[float], list[str]]:
    """Places and labels of survival [%] on an axis of ln(ln(1/P_s)), apart enough to read."""
    places: list[float] = []
    labels: list[str] = []
    for share in _SURVIVAL:
        place = 0.0 if share == 37 else float(np.log(-np.log(share / 100.0)))
        apart = all(abs(place - other) > 0.045 * (top - bottom) for other in places)
        if bottom <= place <= top and apart:
            places.append(place)
            labels.append(f"{share:g}")
    return places, labels
