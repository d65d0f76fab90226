"""How much the readings of a channel scatter, from readings close to each other."""

import numpy as np

_NORMAL = 1.4826
"""Standard deviation of a normal law over its median absolute deviation."""
FEWEST = 6
"""Readings without which no noise is estimated."""
ALIKE = 25
"""Readings of about the same stress, at least, that their noise is found from."""
MOST_GROUPS = 12
ENOUGH = 500
"""Differences that are looked at, evenly chosen."""
COUNTS = 4
"""Steps of one count, up and down each, without which a least step is none."""
LEAST, FULL = 1e-3, 2e-4
"""Smallest noise of stress that is reckoned with: as a share of the stress, and of the highest stress of the test."""
USUAL, USUAL_FULL = 0.025, 0.0005
"""Noise of stress that is not doubted, as the same two shares."""
_DOUBT = 2.0
"""How fast the likelihood of a larger noise falls with the square of its logarithm."""


def noise_level(values: np.ndarray, x: np.ndarray) -> float:
    """Standard deviation of one reading of a channel (n,) at places x (n,), not falling; in its unit.

    0 for fewer than six readings.
    """
    if len(values) < FEWEST:
        return 0.0
    return float(_NORMAL * np.median(np.abs(_to_line(values, x))))


def stress_noise(stress: np.ndarray, x: np.ndarray) -> np.ndarray:
    """Standard deviation (n,) of each reading of stress (n,) [Pa] at places x (n,), not falling.

    It follows the level of stress, and is found among the readings of about the same stress where there are enough.
    """
    level = np.abs(np.median(_with_neighbours(stress), axis=1))
    top = float(np.abs(stress).max()) or 1.0
    least = LEAST * level + max(0.1 * FULL * top, count(stress))
    if len(stress) < FEWEST:
        return LEAST * level + FULL * top
    groups = min(len(stress) // ALIKE, MOST_GROUPS)
    if groups < 2:
        scale = np.maximum(level, FULL * top)
        share = _scatter(stress, x, scale, USUAL)
        return np.hypot(share * level, FULL * top)
    high = level > 0.1 * top
    overall = _scatter(stress, x, np.maximum(level, FULL * top), 1.0, high, USUAL)
    places, found = [], []
    for low, high in zip(*_bounds(level, groups)):
        scale = (low + high) / 2 + FULL * top
        likely = 1.5 * overall + USUAL_FULL * top / scale
        inside = (level >= low) & (level <= high)
        share = _scatter(stress, x, np.full(len(stress), scale), 1.0, inside, likely)
        places.append(np.median(level[inside]))
        found.append(share * scale)
    return np.maximum(np.interp(level, places, found), least)


def count(values: np.ndarray) -> float:
    """Least step between readings (n,) that go up and down by it again and again: one count of the instrument.

    0 where there is none.
    """
    steps = np.diff(values)
    sizes = np.abs(steps)
    if not sizes.any():
        return 0.0
    least = sizes[sizes > 1e-9 * np.abs(values).max()].min(initial=np.inf)
    ups, downs = (np.sum(np.abs(sense * steps - least) < 1e-3 * least) for sense in (1, -1))
    return float(least) if min(ups, downs) >= max(COUNTS, 0.01 * len(steps)) else 0.0


def _bounds(level: np.ndarray, groups: int) -> tuple[np.ndarray, np.ndarray]:
    """Least and largest level of each of so many groups of equal size."""
    parts = np.array_split(np.sort(level), groups)
    return np.array([part[0] for part in parts]), np.array([part[-1] for part in parts])


def _scatter(
    stress: np.ndarray,
    x: np.ndarray,
    scale: np.ndarray,
    most: float,
    inside: np.ndarray | None = None,
    likely: float = 1.0,
) -> float:
    """Standard deviation of a reading over `scale` (n,), of those `inside`: the lesser of what two kinds of
    differences tell, since a slope enlarges the one and a corner the other."""
    to_line = _to_line(stress, x) / scale[1:-1]
    to_next = np.diff(stress) / np.sqrt(2) / np.maximum(scale[1:], scale[:-1])
    if inside is not None:
        to_line, to_next = to_line[inside[1:-1]], to_next[inside[1:] | inside[:-1]]
    return min(_at_rest(differences, most, likely) for differences in (to_line, to_next))


def _to_line(values: np.ndarray, x: np.ndarray) -> np.ndarray:
    """Each inner reading less the line between its neighbours (n - 2,), scaled to the deviation of a reading.

    Gasser, Sroka & Jennen-Steinmetz (1986).
    """
    before, after = np.diff(x)[:-1], np.diff(x)[1:]
    reach = before + after
    share = np.divide(after, reach, out=np.full_like(reach, 0.5), where=reach > 0)
    rest = share * values[:-2] + (1 - share) * values[2:] - values[1:-1]
    return rest / np.sqrt(share**2 + (1 - share) ** 2 + 1)


def _at_rest(differences: np.ndarray, most: float, likely: float) -> float:
    """Standard deviation of the differences of readings at rest, among those of readings in motion.

    The likeliest of a mixture of a normal law and of differences even in their logarithm, from 1e-4 to `most`; more
    than `likely` is doubted.
    """
    size = np.abs(differences[:: 1 + len(differences) // ENOUGH])
    sigma = np.geomspace(1e-4, most, 80)[:, None, None]
    rests = np.linspace(0.1, 0.95, 18)[None, :, None]
    normal = np.sqrt(2 / np.pi) / sigma * np.exp(-0.5 * (size / sigma) ** 2)
    moves = 1 / (np.maximum(size, sigma / 2) * np.log(8 / sigma))
    likelihood = np.log(rests * normal + (1 - rests) * moves).sum(axis=2)
    likelihood -= _DOUBT * np.log(np.maximum(sigma[:, :, 0] / likely, 1.0)) ** 2
    return float(sigma[np.unravel_index(likelihood.argmax(), likelihood.shape)[0], 0, 0])


def _with_neighbours(values: np.ndarray) -> np.ndarray:
    """Each reading with the one before and after it (n, 3)."""
    return np.lib.stride_tricks.sliding_window_view(np.pad(values, 1, mode="edge"), 3)
