"""From a recording and a model card to a verdict."""

import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from grus.card import Card
from grus.diagnosis.calibration import calibrate
from grus.diagnosis.collapse import Collapse
from grus.diagnosis.creep import Creep
from grus.diagnosis.diagnosis import Diagnosis
from grus.diagnosis.draining import Draining
from grus.diagnosis.estimate import culprits
from grus.diagnosis.evidence import Explanation, explanations
from grus.diagnosis.fingerprint import Fingerprint
from grus.diagnosis.improvement import improve
from grus.diagnosis.layout import Layout, layout
from grus.diagnosis.library import Library, library
from grus.diagnosis.locate import misfit
from grus.diagnosis.measurement import next_measurement
from grus.diagnosis.plan import SEEDS, directions
from grus.diagnosis.protocol import protocol
from grus.diagnosis.put_back import PutBack, put_back
from grus.diagnosis.scaling import Scaling
from grus.diagnosis.simulator import Simulator
from grus.diagnosis.small_model import small_model
from grus.diagnosis.suspect import UNKNOWN, Known, Suspect, Unknown
from grus.diagnosis.verdict import confirmed, decide
from grus.diagnosis.whiteness import whiteness
from grus.mechanisms import MECHANISMS
from grus.record import Record
from grus.recording import read, segments

RUNS = "diagnosis-runs"
"""Folder of the runs, in the current one."""
TEMPER = 0.8
"""Power of the likelihood; found on development trials. The covariance knows less of specimens than there is."""


def diagnose(
    recording: Record | str | Path,
    card: Card | str | Path,
    store: str | Path = RUNS,
    seed: int = 1,
    jobs: int | None = None,
    budget: float | None = None,
    say: Callable[[str], None] = lambda line: None,
    program: list[str] | None = None,
) -> Diagnosis:
    """What physics the model of `card` leaves out, by a recording of a laboratory test.

    recording: a record with axial stress and strain, or the file of one. card: of a model with an oedometer test, or its
    file. store: folder of the runs, which further
    diagnoses of the same test share. seed: of the specimens. jobs: runs at a time, by default one a core. budget: time [s]
    after which no run is begun; fingerprints that are missing then are not looked for, and the diagnosis says so.
    program: stages in the words of a card, when they are known. `say` is called with a line on each step.

    Raises GrusError when the recording or the card makes no sense, or the base cannot be simulated.
    """
    start = time.monotonic()
    if not isinstance(recording, Record):
        recording = read(recording)
    if not isinstance(card, Card):
        card = Card.from_file(card)
    recording = replace(recording, segments=segments(recording, program))
    plan = protocol(recording, program)
    small = small_model(card)
    deadline = None if budget is None else start + budget
    seeds = tuple(1000 * seed + k for k in range(2 * SEEDS))
    improvement, telling = None, ""
    with Simulator(small, plan, store, jobs, deadline, say) as simulator:
        calibration = calibrate(layout(recording, plan), simulator, seeds)
        compared = calibration.compared
        wanted, unfit = directions(plan, small)
        made = library(compared, simulator, calibration.base, seeds, wanted, recording)
        suspected = suspects(compared, made)
        difference = compared.measured - made.scatter.mean
        covariance = made.covariance + compared.noise
        found = explanations(difference, covariance, suspected, TEMPER)
        rest = _rest(difference, covariance, found, suspected)
        decision = decide(found, not made.skipped, rest.smallest)
        scaling = Scaling(
            calibration.stiffness, plan.scale, _height(small) / _height(card, recording)
        )
        named = culprits(decision.named, decision.probability, found, suspected, scaling)
        if decision.kind == "named":
            best = _best(found, decision.named)
            ran = put_back(
                compared,
                simulator,
                calibration.base,
                seeds,
                named,
                best,
                suspected,
                scaling,
            )
            if ran is not None:
                named = list(ran.culprits)
                improvement = improve(compared, made, best, suspected, ran)
            if ran is None:
                decision = confirmed(decision, None)
            else:
                decision = confirmed(decision, ran.reproduced, ran.between is not None)
            if decision.kind == "cannot_tell":
                telling = _unreproduced(ran)
        elif decision.kind == "cannot_tell":
            telling = _missing(made) or next_measurement(
                recording, compared, made, found, suspected
            )
    return Diagnosis(
        recording=recording,
        recording_name=str(recording.meta.get("source", "")),
        recording_hash=str(recording.meta.get("sha256", "")),
        card=card,
        small=small,
        protocol=plan,
        calibration=calibration,
        library=made,
        misfit=tuple(misfit(compared, difference, covariance)),
        explanations=tuple(found),
        decision=decision,
        culprits=tuple(named),
        whiteness=rest,
        improvement=improvement,
        next_measurement=telling,
        seed=seed,
        runs=len(simulator.outcomes),
        seconds=time.monotonic() - start,
        notes=(
            *recording.notes,
            *(f"{MECHANISMS[k].title} was not looked for: {why}" for k, why in unfit.items()),
        ),
    )


def _height(card: Card, recording: Record | None = None) -> float:
    """Of the recording's specimen [m] where it is known, else of the card's."""
    known = None if recording is None else recording.meta.get("height")
    return float(card.specimen.height if known is None else known)


def _best(found: Sequence[Explanation], named: Sequence[str]) -> Explanation:
    """The most probable explanation by the named mechanisms alone; by those and others when there is none."""
    by_mechanisms = [(e, {n.split(":")[0] for n in e.names}) for e in found]
    alone = [e for e, names in by_mechanisms if names == set(named)]
    return alone[0] if alone else next(e for e, names in by_mechanisms if names >= set(named))


def _missing(made: Library) -> str:
    """What keeps a verdict open before any measurement could."""
    if not made.skipped:
        return ""
    return f"no measurement yet: first the runs of {', '.join(made.skipped)}, with a larger budget"


def _unreproduced(ran: PutBack | None) -> str:
    """Why a mechanism that fits is not named."""
    why = (
        "no run with it came to an end"
        if ran is None
        else f"the runs with it show {ran.reproduced:.2g} times the effect that the recording asks for"
    )
    return f"no measurement, but other runs: the mechanism fits, but {why}"


def suspects(compared: Layout, made: Library) -> list[Suspect]:
    """All that may have been left out, known or not."""
    typical = np.abs([made.scatter.mean, compared.measured]).max(axis=0)
    ratios = bool(compared.ratios)
    loads = compared.where(channel="strain", kind="load")
    broken = float((compared.measured - made.scatter.elastic)[loads].sum())
    return [
        *(_known(one, compared, broken) for one in made.fingerprints),
        Draining(compared),
        *(Unknown(where, compared, typical) for where in UNKNOWN if where != "ratio" or ratios),
    ]


def _known(one: Fingerprint, compared: Layout, broken: float) -> Known:
    if one.mechanism.name == "bond_ageing":
        return Creep(one, compared, broken)
    if one.mechanism.name == "wetting_collapse":
        return Collapse(one, compared, broken)
    return Known(one, compared)


def _rest(difference, covariance, found, suspected):
    """Whiteness of what the best explanation by known mechanisms leaves."""
    by_name = {s.name: s for s in suspected}
    best = next(e for e in found if not any(n.startswith("unknown:") for n in e.names))
    for name, size in zip(best.names, best.best()):
        change, more = by_name[name].effect(size)
        difference, covariance = difference - change, covariance + more
    return whiteness(difference, covariance)
