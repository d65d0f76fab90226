"""What an oedometer test says beyond its record: gradings, breakage, yield."""

from dataclasses import dataclass

import numpy as np

from grus.compression import BreakageOnset, YieldStress, breakage_onset, yield_stress
from grus.errors import GrusError
from grus.grading import Breakage, Fragments, Grading, sieve_series
from grus.oedometer.result import OedometerResult

NO_YIELD = "a law without yield describes the compression curve as well"
NO_BREAKAGE = "no bond broke"
NO_ONSET = "breakage turns steeper at no stress"


@dataclass(frozen=True)
class Analysis:
    """Of one test; gradings and breakage of each stage, the seating first, against that of the seating.

    fragments, gradings, breakage: one a stage; all gradings on the same sieves. yielding, onset: or in words why there is
    none. rows: of the record, at which the stages ended.
    """

    fragments: tuple[Fragments, ...]
    gradings: tuple[Grading, ...]
    breakage: tuple[Breakage | str, ...]
    yielding: YieldStress | str
    onset: BreakageOnset | str
    rows: np.ndarray

    @classmethod
    def of(cls, result: OedometerResult) -> "Analysis":
        specimen = result.prepared.specimen
        fragments = tuple(
            Fragments.of_labels(specimen, end.state.fragment) for end in result.stages
        )
        sizes = [part.sieve_size for part in fragments]
        sieves = sieve_series(min(s.min() for s in sizes), max(s.max() for s in sizes))
        gradings = tuple(part.grading(sieves) for part in fragments)
        smallest = float(2 * specimen.radius.min())
        stages = result.record["stage"]
        return cls(
            fragments,
            gradings,
            tuple(_breakage(gradings[0], one, specimen.dimension, smallest) for one in gradings),
            _yielding(result),
            _onset(result),
            np.searchsorted(stages, np.arange(len(result.stages)), side="right") - 1,
        )

    def lost_mass(self) -> float:
        """Largest change of the mass of all fragments since the seating, over that mass [-]."""
        volume = np.array([part.volume.sum() for part in self.fragments])
        return float(np.abs(volume / volume[0] - 1).max())


def _breakage(before: Grading, after: Grading, dimension: int, smallest: float) -> Breakage | str:
    """Down to the diameter of an element, the `smallest` size that breakage can leave [m]."""
    try:
        return Breakage.between(before, after, dimension=dimension, smallest=smallest)
    except GrusError as error:
        return str(error)


def _yielding(result: OedometerResult) -> YieldStress | str:
    seating = float(result.card.preparation.seating_stress)
    try:
        return yield_stress(result.stress, result.void_ratio, seating=seating) or NO_YIELD
    except GrusError as error:
        return str(error)


def _onset(result: OedometerResult) -> BreakageOnset | str:
    seating = float(result.card.preparation.seating_stress)
    try:
        return breakage_onset(result.stress, result.broken, seating=seating)
    except GrusError as error:
        return str(error)
