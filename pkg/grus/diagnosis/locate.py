"""Where a recording and the calibrated base differ: shares of the misfit by stage and channel."""

from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from scipy.linalg import cho_factor, cho_solve

from grus.diagnosis.layout import Layout


@dataclass(frozen=True)
class StageMisfit:
    """stage: number in the recording. kind: what was done. t0, t1: time [s], None without. stress_from, stress_to [Pa].
    channel: "strain", "base", "lateral" or "events". chi2: squared difference from the base over what noise and scatter explain.
    numbers: how many are compared; as much is expected. share: of the misfit of all stages beyond what is expected.
    """

    stage: int
    kind: str
    channel: str
    t0: float | None
    t1: float | None
    stress_from: float
    stress_to: float
    chi2: float
    numbers: int
    share: float

    def to_dict(self) -> dict[str, Any]:
        return asdict(self)


def misfit(compared: Layout, difference: np.ndarray, covariance: np.ndarray) -> list[StageMisfit]:
    """Of a recording less the base (n,), with the covariance of this (n, n)."""
    found = []
    for channel in ("strain", "base", "lateral", "events"):
        for number, segment in enumerate(compared.protocol.segments):
            own = compared.where(stage=number, channel=channel)
            if own.any():
                chi2 = chi_squared(difference[own], covariance[np.ix_(own, own)])
                found.append((number, segment, channel, chi2, int(own.sum())))
    excess = np.array([max(chi2 - numbers, 0.0) for *_, chi2, numbers in found])
    shares = excess / excess.sum() if excess.sum() > 0 else excess
    return [
        StageMisfit(
            segment.stage,
            segment.kind,
            channel,
            segment.t0,
            segment.t1,
            segment.stress_from,
            segment.stress_to,
            chi2,
            numbers,
            float(share),
        )
        for (_, segment, channel, chi2, numbers), share in zip(found, shares)
    ]


def chi_squared(x: np.ndarray, covariance: np.ndarray) -> float:
    """Of `x` (n,) with mean 0."""
    return float(x @ cho_solve(cho_factor(covariance, lower=True), x))
