"""Random removal of elements from an agglomerate."""

import numpy as np

from grus.specimen.require import require


def remaining(count: int, fraction: float, generator: np.random.Generator) -> np.ndarray:
    """Indices (k,) of the elements that are left when a fraction of `count` is taken out.

    The flaws of McDowell & Bolton (1998), Geotechnique 48, 667-679, as used by Cheng et al. (2003),
    Geotechnique 53, 633-641: agglomerates that lack different elements differ in strength.
    fraction: in [0, 1); the number taken out is rounded, and at least one element stays. All
    choices are equally likely. Indices ascend. Raises GrusError for another fraction.
    """
    require(0 <= fraction < 1, "missing", fraction, "a fraction in [0, 1)")
    removed = min(int(fraction * count + 0.5), count - 1)
    order = np.argsort(generator.random(count), kind="stable")
    return np.sort(order[removed:])
