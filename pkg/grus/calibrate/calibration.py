"""What a calibration has found."""

from dataclasses import dataclass

from grus.calibrate.intervals import Intervals
from grus.calibrate.targets import Targets
from grus.calibrate.trial import Trial
from grus.card import Card


@dataclass(frozen=True)
class Calibration:
    """The trials and what follows from them.

    card: as it was given. trials: all, in their order. intervals: of the parameters, None when the trials are too few.
    runs, failed: number of simulations of all trials, and of those that failed. versions: by name.
    """

    card: Card
    targets: Targets
    trials: tuple[Trial, ...]
    intervals: Intervals | None
    runs: int
    failed: int
    versions: dict[str, str]

    @property
    def best(self) -> Trial:
        """The trial with the smallest misfit, the first of several."""
        return min(self.trials, key=lambda trial: trial.misfit)

    @property
    def calibrated(self) -> Card:
        """The card with the parameters of the best trial."""
        return changed(self.card, self.targets, self.best.values)


def changed(card: Card, targets: Targets, values: tuple[float, ...]) -> Card:
    """The card with these values (p,) of the parameters, in SI. Raises CardError."""
    overrides: dict[str, float | str] = {}
    for parameter, value in zip(targets.parameters, values):
        overrides |= parameter.overrides(value)
    return card.with_overrides(overrides)
