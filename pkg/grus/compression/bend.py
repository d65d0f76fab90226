"""Where a curve bends most sharply."""

import numpy as np

SHARE = 0.15
"""Half width of the window of a local fit, as a share of the range of x."""
NEIGHBOURS = 6
"""Readings that a window holds at least."""
PLACES = 201


def sharpest_bend(x: np.ndarray, y: np.ndarray) -> float | None:
    """Place where the slope of a curve falls fastest; None when it nowhere does.

    x (n,) rising, y (n,). The curve is smoothed by local parabolas with tricube weights (LOESS,
    Cleveland 1979). Casagrande's point of largest curvature depends on the scales of the drawing;
    the largest second derivative does not.
    """
    reach, height = np.ptp(x), np.ptp(y) or 1.0
    u, v = (x - x[0]) / reach, y / height
    place = np.linspace(SHARE / 2, 1 - SHARE / 2, PLACES)
    distance = np.abs(u - place[:, None])
    width = np.maximum(SHARE, 1.001 * np.sort(distance, axis=1)[:, min(NEIGHBOURS, len(u)) - 1])
    weight = np.sqrt(np.clip(1 - (distance / width[:, None]) ** 3, 0, None) ** 3)
    fall = np.empty(PLACES)
    for i, (centre, row) in enumerate(zip(place, weight)):
        basis = np.vander(u - centre, 3) * row[:, None]
        fall[i] = -np.linalg.lstsq(basis, v * row, rcond=None)[0][0]
    sharpest = int(fall.argmax())
    return float(x[0] + reach * place[sharpest]) if fall[sharpest] > 1e-9 else None
