"""Random streams of a specimen: one for each purpose of each grain."""

from enum import IntEnum

import numpy as np

from grus.specimen.require import require


class Purpose(IntEnum):
    """What a stream is drawn for; the numbers are part of the seeding and never change."""

    LATTICE = 0
    STAMP = 1
    MISSING = 2
    ORIENTATION = 3


def stream(seed: int, grain: int, purpose: Purpose) -> np.random.Generator:
    """Generator that depends on nothing but its three arguments.

    seed, grain: whole numbers >= 0. Callers use `Generator.random` only, the one method whose
    values are the same in every version of numpy. Raises GrusError for negative numbers.
    """
    require(seed >= 0, "seed", seed, ">= 0")
    require(grain >= 0, "grain", grain, ">= 0")
    sequence = np.random.SeedSequence(entropy=int(seed), spawn_key=(int(grain), int(purpose)))
    return np.random.Generator(np.random.PCG64(sequence))
