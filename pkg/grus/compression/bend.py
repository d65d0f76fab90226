"""Where a curve bends most sharply."""

import numpy as np

SHARE = 0.2
"""Half width of the window of a local fit, as a share of the range of x."""
NEIGHBOURS = 6
"""Readings that a window holds at least."""


def sharpest_bend(x: np.ndarray, y: np.ndarray) -> float | None:
    """Place of the largest curvature of a curve that bends downwards; None when it nowhere does.

    x (n,) rising, y (n,). The curve is smoothed by local parabolas with tricube weights (LOESS,
    Cleveland 1979); curvature is that of the drawing in which both ranges are equally long.
    """
    x_range, y_range = np.ptp(x), np.ptp(y) or 1.0
    u, v = (x - x[0]) / x_range, y / y_range
    place = np.linspace(SHARE / 2, 1 - SHARE / 2, 201)
    distance = np.abs(u - place[:, None])
    width = np.maximum(SHARE, 1.001 * np.sort(distance, axis=1)[:, min(NEIGHBOURS, len(u)) - 1])
    weight = np.sqrt(np.clip(1 - (distance / width[:, None]) ** 3, 0, None) ** 3)
    curvature = np.empty(len(place))
    for i, (centre, row) in enumerate(zip(place, weight)):
        basis = np.vander(u - centre, 3) * row[:, None]
        second = np.linalg.lstsq(basis, v * row, rcond=None)[0][0]
        curvature[i] = -2 * second
    sharpest = int(curvature.argmax())
    return float(x[0] + x_range * place[sharpest]) if curvature[sharpest] > 1e-9 else None
