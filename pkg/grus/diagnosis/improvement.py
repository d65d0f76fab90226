"""Whether the fit gets better when the mechanisms are put back into the model."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from itertools import product
from typing import Any

import numpy as np

from grus.diagnosis.collapse import Collapse
from grus.diagnosis.evidence import Explanation
from grus.diagnosis.layout import Layout
from grus.diagnosis.library import Library
from grus.diagnosis.predict import Effects, Error, error, predicted
from grus.diagnosis.put_back import PutBack
from grus.diagnosis.suspect import Suspect

ACTS = 1.0
"""Change of the strain of a stage, or of the stress at the base at its end, in standard deviations of specimens without it,
from which a mechanism acts there."""
LATER = 0.25
"""Share of the time of a hold after which it is foreseen, where what was left out acts in this hold only."""
FEW = 5
"""Sizes of each of several mechanisms between which the stages that were seen choose."""


@dataclass(frozen=True)
class Fit:
    """How well a model fits.

    overall: all stages, after all were seen. where_it_acts: only those in which the mechanisms change the test. left_out:
    each stage in which they do, after only the others were seen; of a single hold what comes after LATER of its time,
    after all before and the other stages were seen. mean (n,): the recording less the base as this model
    has it after seeing all. foreseen (n,): the same, with what was left out as it was foreseen.
    """

    overall: Error
    where_it_acts: Error
    left_out: Error
    mean: np.ndarray
    foreseen: np.ndarray

    def to_dict(self, stiffness: float) -> dict[str, Any]:
        """Without the curves; strains as recorded, which were multiplied by the stiffness of the calibration."""
        overall, acts, left_out = (
            asdict(one) | {"rmse_strain": one.rmse_strain / stiffness}
            for one in (self.overall, self.where_it_acts, self.left_out)
        )
        return {**overall, "where_it_acts": acts, "left_out": left_out}


@dataclass(frozen=True)
class Improvement:
    """before, after: fits without and with the mechanisms. put_back: the runs in which they were put back into the
    engines. left_out: stages of the protocol in which they act, each of which was foreseen from the others. later: whether
    it is one hold, of which only what comes after LATER of its time was. foretold: whether what was seen could foretell it:
    the rest of the test says nothing of a single ramp, nor of a collapse.
    """

    before: Fit
    after: Fit
    put_back: PutBack
    left_out: tuple[int, ...]
    later: bool
    foretold: bool = True

    @property
    def change(self) -> np.ndarray:
        """What the mechanisms changed in the runs (n,)."""
        return self.put_back.change

    @property
    def specimens(self) -> int:
        """That were run to the end with the mechanisms on."""
        return self.put_back.specimens

    @property
    def overfit(self) -> bool:
        """Whether only the stages that were fitted got better, of those that others could foretell."""
        return (
            self.foretold
            and self.after.overall.rmse_strain < 0.9 * self.before.overall.rmse_strain
            and self.after.left_out.rmse_strain >= self.before.left_out.rmse_strain
        )


def improve(
    compared: Layout,
    made: Library,
    best: Explanation,
    suspects: Sequence[Suspect],
    ran: PutBack,
) -> Improvement:
    """Fits without and with the mechanisms of the best explanation, of all sizes, between which the stages that were seen
    choose."""
    n = len(compared.measured)
    by_name = {s.name: s for s in suspects}
    members = [by_name[name] for name in best.names]
    acting = _acting(compared, made, members, best.best())
    later = _later(compared, acting)
    before, after = (
        _fit(compared, made, effects, acting, later)
        for effects in ([(np.zeros(n), np.zeros((n, n)))], _effects(members))
    )
    sudden = all(isinstance(m, Collapse) for m in members)
    foretold = not sudden and (later is not None or len(acting) > 1)
    return Improvement(before, after, ran, acting, later is not None, foretold)


def _effects(members: Sequence[Suspect]) -> list[tuple[np.ndarray, np.ndarray]]:
    """Change and its covariance at every combination of sizes."""
    grids = [m.grid for m in members]
    if len(members) > 1:
        grids = [g[np.unique(np.linspace(0, len(g) - 1, FEW).round().astype(int))] for g in grids]
    result = []
    for sizes in product(*grids):
        parts = [m.effect(size) for m, size in zip(members, sizes)]
        result.append((sum(change for change, _ in parts), sum(more for _, more in parts)))
    return result


def _acting(
    compared: Layout, made: Library, members: Sequence[Suspect], sizes: Sequence[float]
) -> tuple[int, ...]:
    """Stages whose strain or stress at the base any of them changes by more than specimens scatter; the one that comes
    closest when there is none."""
    covariance = made.covariance + compared.noise
    effects = [m.effect(size)[0] for m, size in zip(members, sizes)]
    over: dict[int, float] = {}
    for stage in {e.stage for e in compared.entries}:
        for channel in ("strain", "base"):
            own = compared.where(stage=stage, channel=channel)
            if own.any():
                spread = np.sqrt(covariance[np.ix_(own, own)].sum())
                times = max(abs(float(change[own].sum())) for change in effects) / spread
                over[stage] = max(over.get(stage, 0.0), float(times))
    found = [stage for stage, times in over.items() if times > ACTS]
    return tuple(sorted(found or [max(over, key=over.__getitem__)]))


def _later(compared: Layout, acting: tuple[int, ...]) -> np.ndarray | None:
    """Which entries (n,) of the only acting stage are foreseen from its beginning; None where it is not a hold with one."""
    own = compared.where(stage=acting[0])
    first = own & np.array([e.channel == "strain" and e.end <= LATER for e in compared.entries])
    if len(acting) > 1 or not (own & compared.where(kind="hold")).any() or not first.any():
        return None
    return own & ~first


def _fit(
    compared: Layout,
    made: Library,
    effects: Effects,
    acting: tuple[int, ...],
    later: np.ndarray | None,
) -> Fit:
    difference = compared.measured - made.scatter.mean
    everything = np.ones(len(difference), dtype=bool)
    acts = np.isin([e.stage for e in compared.entries], acting)
    noise = compared.noise
    mean, spread = predicted(difference, made.covariance, noise, effects, everything)
    foreseen, unseen = mean.copy(), spread.copy()
    parts = [compared.where(stage=one) for one in acting] if later is None else [later]
    for own in parts:
        told, doubt = predicted(difference, made.covariance, noise, effects, ~own)
        foreseen[own] = told[own]
        unseen[np.ix_(own, own)] = doubt[np.ix_(own, own)]
        # Stages are foreseen one by one: what their errors have in common is not counted.
        unseen[np.ix_(own, ~own)] = unseen[np.ix_(~own, own)] = 0.0
    return Fit(
        error(compared, difference, mean, spread, everything),
        error(compared, difference, mean, spread, acts),
        error(compared, difference, foreseen, unseen, np.any(parts, axis=0)),
        mean,
        foreseen,
    )
