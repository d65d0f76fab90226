"""Jumps of strain inside a hold or a move: sudden breakage, collapse, a change of load that is not recorded, a slip."""

import numpy as np

from grus.recording.noise import noise_level

LONGEST = 4
"""Intervals between readings that a jump may take."""
WINDOW = 5
"""Readings whose median is a level; two levels on either side of a jump tell what is usual."""
FEWEST = 4 * WINDOW + 2
"""Readings of a segment without which no jumps are looked for."""
CLEAR = 7.0
"""Smallest jump beyond the usual change, in standard deviations of the difference of two levels."""
UNLIKE = 3.0
"""The same over the usual change."""
AT_ONCE = 0.7
"""Share of the jump, at least, that is done within its own intervals."""
_MEDIAN = 1.2533
"""Standard error of a median over that of a mean, of a normal law."""


def find_jumps(strain: np.ndarray, x: np.ndarray) -> list[tuple[int, int]]:
    """First and last index of each jump of strain (n,) along x (n,), which rises or falls.

    x is the time, or the stress of a move.
    """
    if len(strain) < FEWEST:
        return []
    noise = noise_level(strain, np.arange(len(strain), dtype=float))
    found = []
    for length in range(1, LONGEST + 1):
        first, size = _jumps(strain, x, length, noise)
        found += [(s / length**0.5, f, f + length) for s, f in zip(size.tolist(), first.tolist())]
    chosen: list[tuple[int, int]] = []
    for _, first, last in sorted(found, reverse=True):
        if all(last + WINDOW < other[0] or first > other[1] + WINDOW for other in chosen):
            chosen.append((first, last))
    return sorted(chosen)


def _jumps(
    strain: np.ndarray, x: np.ndarray, length: int, noise: float
) -> tuple[np.ndarray, np.ndarray]:
    """First index of each jump over so many intervals, and the change in them."""
    levels, places = (
        np.median(np.lib.stride_tricks.sliding_window_view(values, WINDOW), axis=1)
        for values in (strain, x)
    )
    first = np.arange(2 * WINDOW - 1, len(strain) - length - 2 * WINDOW + 1)
    # Windows, by their first reading: two up to the jump, two from its end on.
    windows = first + np.array([[1 - 2 * WINDOW], [1 - WINDOW], [length], [length + WINDOW]])
    level, place = levels[windows], places[windows]
    with np.errstate(divide="ignore", invalid="ignore"):
        rates = np.abs((level[[1, 3]] - level[[0, 2]]) / (place[[1, 3]] - place[[0, 2]]))
    usual = np.nan_to_num(rates.max(axis=0) * np.abs(place[2] - place[1]), nan=0.0)
    step = level[2] - level[1]
    scatter = _MEDIAN * np.sqrt(2 / WINDOW) * noise
    change = (strain[first + length] - strain[first]) * np.sign(step)
    jumps = (
        (np.abs(step) > usual + CLEAR * scatter)
        & (np.abs(step) > UNLIKE * usual)
        & (change >= AT_ONCE * np.abs(step))
    )
    return first[jumps], change[jumps]
