"""Random streams of a preparation."""

from enum import IntEnum

import numpy as np


class Step(IntEnum):
    """What a stream is drawn for; the numbers are part of the seeding and never change."""

    DIAMETERS = 1001
    PLACES = 1002
    TAPS = 1003


def stream(seed: int, step: Step, attempt: int = 0) -> np.random.Generator:
    """Generator that depends on nothing but its arguments; callers use `Generator.random` only."""
    sequence = np.random.SeedSequence(entropy=seed, spawn_key=(0, int(step), attempt))
    return np.random.Generator(np.random.PCG64(sequence))
