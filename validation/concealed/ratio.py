"""How large an effect is beside what scatters without it."""

import numpy as np

from conceal import Concealment
from curve import Curve

POINTS = 6  # of a stage
SHARE = 0.2  # of the largest: a stage acts when the effect in it is at least that


def features(curve: Curve) -> np.ndarray:
    """Strains inside each stage from its beginning (stages, POINTS), and the base stress over the top stress if given.

    Differences inside a stage, because the level of strain of a small specimen scatters for no reason that matters.
    """
    found = []
    for _, window, rests in curve.windows():
        time, strain = curve.time[window], curve.strain[window]
        shares = np.geomspace(0.02, 1, POINTS) if rests else np.arange(1, POINTS + 1) / POINTS
        at = time[0] + (time[-1] - time[0]) * shares
        found.append(np.interp(at, time, strain) - strain[0])
        if "base_stress" in curve.others:
            share = curve.others["base_stress"] / np.maximum(curve.stress, 1.0)
            found.append(np.interp(at, time, share[window]))
    return np.array(found)


def noise(curve: Curve, how: Concealment) -> np.ndarray:
    """Standard deviation of the features from noise alone: each stands for its share of the readings of its stage."""
    deviations = []
    for _, window, rests in curve.windows():
        readings = max((how.hold if rests else how.ramp) / POINTS, 1.0)
        strain = float(np.median(how.strain_noise(curve.strain[window])))
        deviations.append(np.full(POINTS, np.sqrt(2 / readings) * strain))
        if "base_stress" in curve.others:
            deviations.append(np.full(POINTS, np.sqrt(2 / readings) * how.stress))
    return np.array(deviations)


def effect_over_scatter(
    on: Curve, off: Curve, others: list[Curve], how: Concealment
) -> dict[str, float]:
    """Size of the effect in units of the combined scatter of seeds and noise.

    on, off: the same specimen with the effect and without. others: other specimens without it. Returns
    `ratio`: root mean square of difference over scatter, over the stages where the effect acts, and
    `ratio_beyond_calibration`: the same after the best combination of what recalibration can do was taken out:
    all strains larger, those of first loading larger, those of first loading beyond half the highest stress larger.
    """
    plain = features(off)
    difference = features(on) - plain
    seeds = np.std([features(other) for other in others], axis=0, ddof=1)
    scatter = np.hypot(seeds, noise(off, how))
    weighted = difference / scatter
    size = np.sqrt((difference**2).mean(axis=1))
    strains = np.array([np.abs(plain).max(axis=1) < 0.3]).ravel()  # the others are shares of stress
    acts = np.zeros(len(size), dtype=bool)
    for kind in (strains, ~strains):
        if kind.any():
            acts |= kind & (size >= SHARE * size[kind].max()) & (size > 0)
    if not acts.any():
        return {"ratio": 0.0, "ratio_beyond_calibration": 0.0}
    beyond = _beyond(weighted, plain * strains[:, None] / scatter, off, strains)
    return {
        "ratio": round(float(np.sqrt((weighted[acts] ** 2).mean())), 3),
        "ratio_beyond_calibration": round(float(np.sqrt((beyond[acts] ** 2).mean())), 3),
    }


def _beyond(weighted: np.ndarray, plain: np.ndarray, off: Curve, strains: np.ndarray) -> np.ndarray:
    """`weighted` without its projection on the directions of recalibration."""
    highest = np.maximum.accumulate(off.stress)
    virgin, beyond_half = [], []
    for _, window, _ in off.windows():
        reached = highest[window]
        new = reached[-1] > 1.01 * reached[0]
        virgin.append(new)
        beyond_half.append(new and reached[-1] > 0.5 * highest[-1])
    rows = np.flatnonzero(strains)
    masks = np.zeros((3, len(strains)))
    masks[0, rows], masks[1, rows], masks[2, rows] = 1, virgin, beyond_half
    basis = np.array([(plain * mask[:, None]).ravel() for mask in masks]).T
    kept = np.linalg.lstsq(basis, weighted.ravel(), rcond=None)[0]
    return (weighted.ravel() - basis @ kept).reshape(weighted.shape)
