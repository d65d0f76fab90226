"""All that a diagnosis has found."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from grus.card import Card
from grus.diagnosis.calibration import Calibration
from grus.diagnosis.estimate import Culprit
from grus.diagnosis.evidence import Explanation
from grus.diagnosis.improvement import LATER, Improvement
from grus.diagnosis.library import Library
from grus.diagnosis.locate import StageMisfit
from grus.diagnosis.protocol import Protocol
from grus.diagnosis.verdict import Decision
from grus.diagnosis.whiteness import Whiteness
from grus.record import Record


@dataclass(frozen=True)
class Diagnosis:
    """What a recording shows of physics that a model leaves out.

    recording: with its segments. recording_hash: SHA-256 of its file, empty for a Record. card: as given; small: the model
    that was run. calibration, library: of the base and of the mechanisms. misfit: by stage. explanations: all sets of
    suspects, most probable first. decision: the verdict. culprits: the mechanisms it names, or cannot tell apart, with
    their sizes. whiteness: of what is left after the best explanation. improvement: None when nothing was put back.
    next_measurement: what would tell, when it cannot; else empty. seed: of the specimens. runs, seconds: that were made.
    """

    recording: Record
    recording_name: str
    recording_hash: str
    card: Card
    small: Card
    protocol: Protocol
    calibration: Calibration
    library: Library
    misfit: tuple[StageMisfit, ...]
    explanations: tuple[Explanation, ...]
    decision: Decision
    culprits: tuple[Culprit, ...]
    whiteness: Whiteness
    improvement: Improvement | None
    next_measurement: str
    seed: int
    runs: int
    seconds: float
    notes: tuple[str, ...] = ()

    @property
    def verdict(self) -> str:
        """ "nothing", "named", "cannot_tell" or "unknown"."""
        return self.decision.kind

    @property
    def stiffness(self) -> float:
        """Stiffness of contacts and bonds as calibrated, over that of the card."""
        return self.calibration.stiffness / self.protocol.scale

    @property
    def difference(self) -> np.ndarray:
        """Recording less base (n,), in the layout of the calibration."""
        return self.calibration.compared.measured - self.library.scatter.mean

    def to_dict(self) -> dict[str, Any]:
        """Numbers and text only, for verdict.json; SI units."""
        base = self.calibration.base
        highest = self.protocol.highest
        fit = self.improvement
        return {
            "verdict": self.verdict,
            "mechanisms": [one.to_dict() for one in self.culprits],
            "probability": self.decision.probability,
            "misfit": [one.to_dict() for one in self.misfit],
            "before": None if fit is None else fit.before.to_dict(self.calibration.stiffness),
            "after": None if fit is None else fit.after.to_dict(self.calibration.stiffness),
            "overfit": fit.overfit if fit is not None and fit.foretold else None,
            "reproduced": None if fit is None else fit.put_back.reproduced,
            "reproduced_between": None if fit is None else fit.put_back.between,
            "stages_left_out": None
            if fit is None
            else [self.protocol.segments[k].stage for k in fit.left_out],
            "left_out_after": LATER if fit is not None and fit.later else None,
            "whiteness": {
                "chi_squared": self.whiteness.chi_squared,
                "runs": self.whiteness.runs,
                "neighbours": self.whiteness.neighbours,
            },
            "calibration": {
                "stiffness_factor": self.stiffness,
                "tensile_strength": base.strength_factor(self.small, highest)
                * float(self.small.bond.tensile_strength),
            },
            "next_measurement": self.next_measurement,
            "skipped": self.library.skipped,
            "recording": {"name": self.recording_name, "sha256": self.recording_hash},
            "model": {"name": self.card.name, "card": self.small.to_dict()},
            "seed": self.seed,
            "runs": self.runs,
            "seconds": self.seconds,
            "notes": list(self.notes),
        }
