"""What specimens of the same model differ by, as a covariance.

Small specimens scatter. A hold of a specimen at rest does not; unloading and reloading scatter by some per cent; first
loading scatters by as much as breakage adds to it, in a heavy-tailed way: a specimen goes through an avalanche or not.
So the strain that comes from breakage is given a wide scatter, in its level and from cell to cell.
"""

from dataclasses import dataclass

import numpy as np

from grus.diagnosis.layout import Layout

LEVEL = {"load": 0.06, "seat": 0.4, "unload": 0.06, "reload": 0.06}
"""Standard deviation of the level of a stage where nothing breaks, as a share."""
SHAPE = {"load": 0.1, "seat": 0.3, "unload": 0.1, "reload": 0.08}
"""From cell to cell. With these the misfit of ramps is 0.8 a number in development trials whose ramps have no effect."""
BROKEN_LEVEL, BROKEN_SHAPE = 1.0, 0.3
"""The same of the strain that comes from breakage."""
BEDDING = 0.3
"""Scatter from cell to cell of first loading under little stress, as a share: how grains bed down on each other."""
CALM = (0.15, 0.4)
"""Stresses over the highest of the test below which no bond breaks, and above which any may."""
GIVES_WAY = 5.0
"""Strain over the elastic one, from which a specimen gives way under little stress too: loose grains fall into place."""
SETTLING = (0.03, 0.004)
"""Strain in the first and in the further cells of a hold, over that of the stage before: rest is never perfect."""
RATIO = {"base": 0.01, "lateral": 0.4}
RATIO_LEVEL = {"base": 0.01, "lateral": 0.8}
"""Standard deviation of the logarithm of a ratio of stresses: of one stage, and of all together. Lateral stress depends
on the packing more than on anything that is looked for."""
MOVING = 0.04
"""The same, added while the stress changes: what is at the base lags behind the top."""


@dataclass(frozen=True)
class Scatter:
    """mean: of the vector over seeds (n,). elastic: the same where nothing breaks (n,). covariance (n, n)."""

    mean: np.ndarray
    elastic: np.ndarray
    covariance: np.ndarray


def scatter(compared: Layout, vectors: np.ndarray, elastic: np.ndarray) -> Scatter:
    """From the vectors of the seeds (s, n) and the mean of such without breakage (n,)."""
    vectors = _alike(compared, vectors)
    mean = np.median(vectors, axis=0)
    seen = np.abs(np.array([mean, compared.measured]))
    size = np.abs(mean)
    covariance = np.zeros((len(mean), len(mean)))
    before = 0.0
    softness = _softness(compared, elastic)
    share = np.array([e.end for e in compared.entries]) / compared.protocol.highest
    breakable = np.clip((share - CALM[0]) / (CALM[1] - CALM[0]), 0.0, 1.0)
    for stage in sorted({e.stage for e in compared.entries}):
        own = compared.where(stage=stage, channel="strain")
        if not own.any():
            continue
        kind = next(e.kind for e in compared.entries if e.stage == stage)
        if kind == "hold":
            # Where no loading before it is compared: what that would have strained.
            before = before or softness * compared.protocol.segments[stage].stress_to
            settling = np.full(own.sum(), SETTLING[1] * before)
            settling[0] = SETTLING[0] * before
            covariance[np.ix_(own, own)] += np.diag(settling**2)
            continue
        # What the recording shows beyond elastic strain may be an avalanche as well; under little stress only what is far
        # beyond it.
        broken = np.zeros(len(mean))
        if kind in ("load", "reload", "seat"):
            most, calm = seen.max(axis=0), np.abs(elastic)
            beyond = np.maximum(most - calm, 0), np.maximum(most - GIVES_WAY * calm, 0)
            broken = (breakable * beyond[0] + (1 - breakable) * beyond[1]) * own
        level = np.hypot(LEVEL[kind] * size, BROKEN_LEVEL * broken) * own
        bedding = BEDDING * (1 - breakable) * size * (kind == "load")
        shape = (
            np.sqrt((SHAPE[kind] * size) ** 2 + (BROKEN_SHAPE * broken) ** 2 + bedding**2) * own
        )
        covariance += np.outer(level, level) + np.diag(shape**2)
        before = float(seen[:, own].max(axis=0).sum())
    for channel, spread in RATIO.items():
        own = compared.where(channel=channel).astype(float)
        level = RATIO_LEVEL[channel] * own
        moving = own * ~compared.where(kind="hold")
        covariance += np.outer(level, level) + np.diag(spread**2 * own + MOVING**2 * moving)
    return Scatter(mean, elastic, covariance + _observed(compared, vectors))


def _softness(compared: Layout, elastic: np.ndarray) -> float:
    """Strain over stress [1/Pa] of all ramps without breakage; 0 without ramps."""
    ramps = compared.where(channel="strain") & ~compared.where(kind="hold")
    spans = sum(
        abs(compared.entries[i].end - compared.entries[i].start) for i in np.flatnonzero(ramps)
    )
    return float(np.abs(elastic[ramps]).sum()) / spans if spans else 0.0


def _alike(compared: Layout, vectors: np.ndarray) -> np.ndarray:
    """The vectors (s, n) with strains scaled to one stiffness of unloading and reloading, which calibration would do."""
    strain = compared.where(channel="strain")
    loops = strain & (compared.where(kind="unload") | compared.where(kind="reload"))
    sizes = np.abs(vectors[:, loops]).sum(axis=1)
    if not loops.any() or not (sizes > 0).all():
        return vectors
    return np.where(strain, vectors * (np.median(sizes) / sizes)[:, None], vectors)


def _observed(compared: Layout, vectors: np.ndarray) -> np.ndarray:
    """Variances between the seeds where they are no avalanches: all but first loading."""
    if len(vectors) < 3:
        return np.zeros((vectors.shape[1],) * 2)
    middle = np.median(vectors, axis=0)
    robust = 1.4826 * np.median(np.abs(vectors - middle), axis=0)
    return np.diag(np.where(compared.where(kind="load"), 0.0, robust) ** 2)
