"""How far a model is from its targets."""

from collections.abc import Mapping

import numpy as np

from grus.calibrate.answers import Answer
from grus.calibrate.targets import Target, Targets

MISSED = 100.0
"""Tolerances by which a target counts as missed that the model does not show at all: more than any that it shows."""


def off(target: Target, answer: Answer) -> np.ndarray | None:
    """Model less target (k,), in tolerances; None when the model does not show it."""
    if answer.missing is not None:
        return None
    return (np.array(answer.values) - np.array(target.values)) / target.tolerance


def misfit(targets: Targets, found: Mapping[str, Answer]) -> float:
    """Sum over targets of the squared distance in tolerances, of a curve the mean square of its values."""
    total = 0.0
    for target in targets.targets:
        distance = off(target, found[target.name])
        total += MISSED**2 if distance is None else float((distance**2).mean())
    return total
