"""What a model shows of the targets: the tests of a trial, and what is read from their outcomes."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.stats import norm

from grus.calibrate.curve import of_test
from grus.calibrate.targets import CRUSH, CURVE, OEDOMETER, Target, Targets
from grus.campaign import Outcome, Run
from grus.card import Card
from grus.errors import GrusError
from grus.statistics import fit_weibull

OF_TESTS = ("bond", "contact", "crush", "oedometer", "ageing", "wetting")
"""Tables whose keys do not shape grains: where these alone are fitted, all trials have the same packings."""
STRESSES = {"yield_stress": "yield", "breakage_onset": "onset"}
"""Target -> name in the figures of an oedometer test."""


@dataclass(frozen=True)
class Answer:
    """What the model shows of a target.

    values: (k,) as those of the target. error: their standard deviation (k,) with other grains or specimens, nan where
    that cannot be told. missing: why there are none, None when there are.
    """

    values: tuple[float, ...] = ()
    error: tuple[float, ...] = ()
    missing: str | None = None


def runs_of(card: Card, base: Card, targets: Targets) -> dict[str, list[Run]]:
    """Runs by kind that a card with changed parameters needs; `base` is the card as it was given."""
    runs: dict[str, list[Run]] = {}
    if targets.of(CRUSH):
        runs[CRUSH] = [Run(CRUSH, card, grain) for grain in range(targets.grains)]
    if targets.of(OEDOMETER):
        single = any(target.name != CURVE for target in targets.of(OEDOMETER))
        kind = OEDOMETER if single else "recording"  # which needs no analysis
        seeds = [{"seed": base.seed + number} for number in range(targets.specimens)]
        names = [name for one in targets.parameters for name in (one.name, *one.tied)]
        same = all(name.partition(".")[0] in OF_TESTS for name in names)
        runs[OEDOMETER] = [
            Run(
                kind, card.with_overrides(s), specimen_card=base.with_overrides(s) if same else None
            )
            for s in seeds
        ]
    return runs


def answers(
    targets: Targets, runs: Mapping[str, Sequence[Run]], outcomes: Mapping[str, Outcome]
) -> dict[str, Answer]:
    """An answer to each target, by its name."""
    found: dict[str, Answer] = {}
    for kind, own in runs.items():
        ended = [outcomes[run.key] for run in own]
        failed = next((one.failed for one in ended if one.failed is not None), None)
        if failed is not None:
            found |= {one.name: Answer(missing=f"failed: {failed}") for one in targets.of(kind)}
        elif kind == CRUSH:
            found |= _of_grains(targets.of(kind), ended)
        else:
            found |= {one.name: _of_specimens(one, ended) for one in targets.of(kind)}
    return {target.name: found[target.name] for target in targets.targets}


def _of_grains(targets: Sequence[Target], outcomes: Sequence[Outcome]) -> dict[str, Answer]:
    strengths = np.array([one.figures["peak.strength"] for one in outcomes])
    unbroken = np.array([one.figures["broken"] == 0 for one in outcomes])
    try:
        fit = fit_weibull(strengths, censored=unbroken if unbroken.any() else None)
    except GrusError as error:
        return {one.name: Answer(missing=str(error)) for one in targets}
    told = {
        "weibull_modulus": (fit.modulus, fit.modulus_ci),
        "characteristic_strength": (fit.sigma0, fit.sigma0_ci),
    }
    answers = {
        name: Answer((value,), (_error(*ci, fit.confidence),)) for name, (value, ci) in told.items()
    }
    return {one.name: answers[one.name] for one in targets}


def _of_specimens(target: Target, outcomes: Sequence[Outcome]) -> Answer:
    """Mean over specimens; its error from their scatter, or from the interval of a single one."""
    if target.name == CURVE:
        values = np.array([of_test(one, target) for one in outcomes])
        return _mean(values, np.full(values.shape[1], np.nan))
    name = STRESSES[target.name]
    if any(f"{name}.stress" not in one.figures for one in outcomes):
        return Answer(missing="not found in the test")
    values = np.array([[one.figures[f"{name}.stress"]] for one in outcomes])
    f = outcomes[0].figures
    single = _error(f[f"{name}.interval.0"], f[f"{name}.interval.1"], f[f"{name}.confidence"])
    return _mean(values, np.array([single]))


def _mean(values: np.ndarray, single: np.ndarray) -> Answer:
    """values: (specimens, k); single: error (k,) of one specimen alone."""
    count = len(values)
    error = values.std(axis=0, ddof=1) / np.sqrt(count) if count > 1 else single
    return Answer(tuple(values.mean(axis=0).tolist()), tuple(error.tolist()))


def _error(low: float, high: float, confidence: float) -> float:
    """Standard deviation of an estimate with this interval."""
    return float((high - low) / (2 * norm.ppf((1 + confidence) / 2)))
