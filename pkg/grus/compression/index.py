"""Compression and swelling index: slopes of void ratio over the logarithm of stress."""

from dataclasses import dataclass

import numpy as np
from scipy.stats import t as t_law

from grus.compression.loading import checked_columns
from grus.compression.readings import Readings
from grus.specimen.require import require


@dataclass(frozen=True)
class CompressionIndex:
    """Fall of the void ratio for a tenfold stress, with its interval at the given confidence."""

    value: float
    interval: tuple[float, float]
    confidence: float


def compression_index(
    stress: np.ndarray, void_ratio: np.ndarray, *, confidence: float = 0.95
) -> CompressionIndex:
    """Index of one segment of a test: Cc of first loading, Cs (swelling) of an unloading.

    stress [Pa], void_ratio [-]: (n,) of the segment, in any order. A straight line over
    log10 stress by generalised least squares, with the noise that `Readings` has.
    Raises GrusError for fewer than three readings, stresses that are not positive or all equal, and
    columns that are no equal lists of finite numbers.
    """
    require(0 < confidence < 1, "confidence", confidence, "in (0, 1)")
    stress, void_ratio = checked_columns(stress, "void_ratio", void_ratio)
    require(len(stress) >= 3, "number of readings", len(stress), "at least 3")
    lowest, highest = stress.min(), stress.max()
    require(lowest > 0, "lowest stress", lowest, "> 0 Pa")
    require(lowest < highest, "stress", f"{lowest:g} throughout", "of different values")
    order = np.argsort(stress, kind="stable")
    curve = Readings(np.log10(stress[order]), void_ratio[order], sense=-1)
    require(curve.count >= 3, "readings apart in log stress", curve.count, "at least 3")
    slope, error = curve.slope()
    reach = t_law.ppf(0.5 + confidence / 2, curve.count - 2) * error
    return CompressionIndex(-slope, (-slope - reach, -slope + reach), float(confidence))
