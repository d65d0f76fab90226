"""One trial of a calibration."""

from collections.abc import Mapping
from dataclasses import dataclass

from grus.calibrate.answers import Answer


@dataclass(frozen=True)
class Trial:
    """Parameters that were tried, and what the model shows with them.

    number: from 1. shares: of each parameter between its bounds (p,); values: in SI (p,). answers: by the names of the
    targets. misfit: see `grus.calibrate.misfit`.
    """

    number: int
    shares: tuple[float, ...]
    values: tuple[float, ...]
    answers: Mapping[str, Answer]
    misfit: float
