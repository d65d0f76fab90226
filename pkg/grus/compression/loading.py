"""The readings of a compression test that tell of yield: those of first loading."""

import numpy as np

from grus.specimen.require import require

FEWEST = 7
"""Readings of first loading without which no break of a line is looked for."""
APART = 6
"""How many of them must be left after those next to each other have been taken together."""


def first_loading(stress: np.ndarray) -> np.ndarray:
    """Mask (n,) of the readings at a stress (n,) [Pa] above zero and above all before.

    Unloading, reloading and the creep of holds drop out.
    """
    stress = np.asarray(stress, dtype=float)
    return stress > np.maximum.accumulate(np.concatenate([[0.0], stress]))[:-1]


def checked_columns(
    stress: np.ndarray, name: str, value: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Stress and value as arrays (n,); `name` is the key of the value.

    Raises GrusError unless both are lists of one length of finite numbers.
    """
    stress, value = np.asarray(stress, dtype=float), np.asarray(value, dtype=float)
    require(stress.ndim == 1, "shape of stress", stress.shape, "one column")
    require(value.shape == stress.shape, f"shape of {name}", value.shape, f"{stress.shape}")
    for key, column in (("stress", stress), (name, value)):
        bad = np.flatnonzero(~np.isfinite(column))
        found = f"{column[bad[0]]} at index {bad[0]}" if len(bad) else None
        require(not len(bad), key, found, "finite")
    return stress, value


def loading_curve(
    stress: np.ndarray, name: str, value: np.ndarray, seating: float
) -> tuple[np.ndarray, np.ndarray]:
    """Stress and value of the readings of first loading from `seating` on.

    stress [Pa], value: (n,) in the order of the test. Raises GrusError as `checked_columns`, and
    when fewer than seven readings are left.
    """
    stress, value = checked_columns(stress, name, value)
    require(0 <= seating < np.inf, "seating", seating, "finite and >= 0 Pa")
    used = first_loading(stress) & (stress >= seating)
    count = int(used.sum())
    require(count >= FEWEST, "readings of first loading", count, f"at least {FEWEST}")
    return stress[used], value[used]


def break_bounds(x: np.ndarray) -> tuple[float, float]:
    """Lowest and highest place of a break between the rising readings x (n,) [log10 stress].

    Two readings are needed before it and three from it on. Raises GrusError for fewer than six.
    """
    require(len(x) >= APART, "readings apart in log stress", len(x), f"at least {APART}")
    return float(x[1]), float(x[-3])
