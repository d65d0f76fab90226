"""A diagnosis in the words of a geotechnical engineer."""

from dataclasses import dataclass

import numpy as np
from scipy.stats import chi2

from grus.diagnosis.diagnosis import Diagnosis
from grus.diagnosis.improvement import LATER, Improvement
from grus.diagnosis.layout import Layout
from grus.diagnosis.locate import StageMisfit
from grus.diagnosis.put_back import PutBack
from grus.diagnosis.report.spoken import chances, number, probability, quantity, size, strain
from grus.diagnosis.report.stages import CHANNELS, done, numbers
from grus.diagnosis.suspect import SPOKEN
from grus.diagnosis.verdict import DECIDED, POSSIBLE, REPRODUCED
from grus.mechanisms import MECHANISMS

MOST_STAGES = 3
"""Stages that are named as those where recording and model differ."""
CLEAR = 0.05
"""Probability of a misfit by chance below which a stage is named."""
ENOUGH = 0.8
"""Share of the misfit after which no further stage is named."""
ORDER, DOUBT = 0.01, 0.1
"""Probabilities of white residuals below which something is left, or may be."""


@dataclass(frozen=True)
class Answers:
    """The verdict in one line, and by question what there is to say, a sentence or two each."""

    verdict: str
    by_question: dict[str, str]


def answers(diagnosis: Diagnosis) -> Answers:
    """To all that a user asks first, in the order of the questions."""
    return Answers(
        _verdict(diagnosis),
        {
            "Where": _where(diagnosis),
            "What": _what(diagnosis),
            "How sure": _how_sure(diagnosis),
            "How large": _how_large(diagnosis),
            "What improves": _what_improves(diagnosis),
            "What it cannot tell": _cannot_tell(diagnosis),
            "What would tell": _what_would_tell(diagnosis),
        },
    )


def title(name: str) -> str:
    """Of a mechanism, as it stands within a sentence."""
    words = MECHANISMS[name].title
    return words[:1].lower() + words[1:]


def _verdict(d: Diagnosis) -> str:
    named = [title(one.name) for one in d.culprits]
    if d.verdict == "nothing":
        return "Nothing is left out: ordinary calibration explains the recording."
    if d.verdict == "unknown":
        return "Something is left out that is none of the known mechanisms."
    if d.verdict == "named":
        overfit = d.improvement is not None and d.improvement.overfit
        but = " Overfit: only the stages it was fitted to get better." if overfit else ""
        return f"The model leaves out {' and '.join(named)}.{but}"
    if len(named) > 1:
        return f"This recording cannot tell {', '.join(named[:-1])} from {named[-1]}."
    if named:
        return f"This recording cannot tell whether the model leaves out {named[0]}."
    return "This recording cannot tell whether anything is left out."


def _where(d: Diagnosis) -> str:
    ordered = sorted(d.misfit, key=lambda one: -one.share)
    clear = [one for one in ordered if chance(d, one) < CLEAR]
    if not clear:
        return "Nowhere: no stage differs by more than noise and the scatter of specimens explain."
    told, total = [], 0.0
    for one in clear[:MOST_STAGES]:
        if total >= ENOUGH or (told and one.share < 0.05):
            break
        total += one.share
        of = "" if told else " of the misfit"
        share = f"{100 * one.share:.0f} %{of} in stage {one.stage} ({done(one)})"
        told.append(f"{share}: {_seen(d, one)}")
    return f"{'; '.join(told)}."


def chance(d: Diagnosis, one: StageMisfit) -> float:
    """Probability that noise and scatter give one of the stages as much misfit as this one has."""
    return min(float(chi2.sf(one.chi2, one.numbers)) * len(d.misfit), 1.0)


def _seen(d: Diagnosis, one: StageMisfit) -> str:
    """What was recorded in a stage, and what the calibrated base does there."""
    compared = d.calibration.compared
    place = next(
        k
        for k, segment in enumerate(d.protocol.segments)
        if (segment.stage, segment.kind, segment.stress_from, segment.stress_to)
        == (one.stage, one.kind, one.stress_from, one.stress_to)
    )
    own = compared.where(stage=place, channel=one.channel)
    pair = (compared.measured[own].sum(), d.library.scatter.mean[own].sum())
    if one.channel == "strain":
        recorded, base = (strain(value / d.calibration.stiffness) for value in pair)
        return f"strain recorded {recorded}, model {base}"
    if one.channel == "events":
        recorded, base = (f"{value:.0%}" for value in pair)
        return f"share of all acoustic events recorded {recorded}, model {base}"
    recorded, base = (number(float(np.exp(value))) for value in pair)
    return f"{CHANNELS[one.channel]} over axial stress recorded {recorded}, model {base}"


def _what(d: Diagnosis) -> str:
    if d.culprits:
        return " ".join(f"{MECHANISMS[one.name].summary}" for one in d.culprits[:2])
    if d.verdict == "unknown" and d.decision.probability["unknown"] < DECIDED:
        return "Something that no known mechanism gives: what the best of them leave has an order of its own."
    if d.verdict == "unknown":
        parts = _unknown_parts(d)
        return f"A change of {' and of '.join(parts)} that no fingerprint of a mechanism gives."
    return _calibrated(d)


def _unknown_parts(d: Diagnosis) -> list[str]:
    """What changes, of the most probable explanation with something unknown."""
    best = next((e for e in d.explanations if any("unknown:" in n for n in e.names)), None)
    names = [] if best is None else [n for n in best.names if n.startswith("unknown:")]
    return [SPOKEN[n.removeprefix("unknown:")] for n in names] or ["the test"]


def _calibrated(d: Diagnosis) -> str:
    strength = d.calibration.base.strength_factor(d.small, d.protocol.highest)
    tensile = quantity(strength * float(d.small.bond.tensile_strength), "Pa")
    return (
        f"Calibration: stiffness of contacts and bonds times {number(d.stiffness)}, "
        f"tensile strength of bonds {tensile}."
    )


def _how_sure(d: Diagnosis) -> str:
    known = d.decision.probability
    named = {one.name for one in d.culprits}
    told = [f"{title(one.name)} {probability(one.probability)}" for one in d.culprits]
    if d.verdict in ("nothing", "unknown"):
        named.add(d.verdict)
        told.append(f"{_SPOKEN[d.verdict]} {probability(known[d.verdict])}")
    others = sorted((n for n in known if n not in named), key=lambda n: -known[n])
    if others and known[others[0]] >= 0.01:
        told.append(
            f"next {_SPOKEN.get(others[0]) or title(others[0])} {probability(known[others[0]])}"
        )
    white = d.whiteness.smallest
    looks = "looks random" if white >= DOUBT else "may not be random"
    looks = "is not random" if white < ORDER else looks
    rest = f"what the best known explanation leaves {looks} ({chances(white)})"
    return f"Probability: {'; '.join(told)}. Check: {rest}."


_SPOKEN = {"nothing": "nothing left out", "unknown": "something unknown"}


def _how_large(d: Diagnosis) -> str:
    told = []
    for one in d.culprits:
        sizes = "; ".join(size(p) for p in one.parameters)
        told.append(sizes if len(d.culprits) == 1 else f"{title(one.name)}: {sizes}")
    if d.improvement is not None:
        compared = d.calibration.compared
        most, place = _largest(compared, d.improvement)
        segment = d.protocol.segments[place]
        added = strain(most / d.calibration.stiffness)
        told.append(
            f"put back into the model it adds {added} of strain in stage {segment.stage} "
            f"({done(segment)}); {_reproduced(d.improvement.put_back)}"
        )
    return f"{'. '.join(t[:1].upper() + t[1:] for t in told)}." if told else "No size to tell."


def _reproduced(ran: PutBack) -> str:
    """How much of the effect the runs show."""
    told = f"in all {number(ran.reproduced)} times the effect that the recording asks for"
    if ran.between is None or max(ran.reproduced, 1 / ran.reproduced) <= REPRODUCED:
        return told
    under, over = ran.between
    return (
        f"{told}. Few grains show {number(under)} times the effect, or at nearly the same size {number(over)} times: one avalanche "
        "more"
    )


def _largest(compared: Layout, fit: Improvement) -> tuple[float, int]:
    """Largest change of strain of a stage by the mechanisms, and the stage's place in the protocol."""
    by_stage = {
        e.stage: float(fit.change[compared.where(stage=e.stage, channel="strain")].sum())
        for e in compared.entries
    }
    place = max(by_stage, key=lambda stage: abs(by_stage[stage]))
    return by_stage[place], place


def _what_improves(d: Diagnosis) -> str:
    fit = d.improvement
    if fit is None:
        return "Nothing was put back into the model."
    before, after = fit.before.left_out.rmse_strain, fit.after.left_out.rmse_strain
    scale = d.calibration.stiffness
    if not fit.foretold:
        without, seen = (f.where_it_acts.rmse_strain / scale for f in (fit.before, fit.after))
        return (
            f"What was left out acts on {numbers(d, fit.left_out)} only, which no other stage can foretell. Error of strain "
            f"there, once it was seen: {strain(without)} without, {strain(seen)} with what was left out."
        )
    told = (
        f"Error of strain on {numbers(d, fit.left_out)}, {foreseen(fit)}: "
        f"{strain(before / scale)} without, {strain(after / scale)} with what was left out"
    )
    if 0 < after < before:
        told += f", {number(before / after)} times less"
    base = [one.left_out.rmse_base for one in (fit.before, fit.after)]
    if None not in base:
        told += f"; of the stress at the base {base[0]:.1%} without, {base[1]:.1%} with"
    overfit = " This is overfit: what was left out gets no better." if fit.overfit else ""
    return f"{told}.{overfit}"


def foreseen(fit: Improvement) -> str:
    """From what the stages that were left out are foreseen."""
    if fit.later:
        return f"what comes after {LATER:.0%} of its time, foreseen from what was before and from all other stages"
    return "each foreseen from all other stages"


def _cannot_tell(d: Diagnosis) -> str:
    told = []
    named = {one.name for one in d.culprits}
    others = [
        _SPOKEN.get(name) or title(name)
        for name, p in sorted(d.decision.probability.items(), key=lambda one: -one[1])
        if p >= POSSIBLE and name not in named | {d.verdict}
    ]
    if d.verdict == "cannot_tell" and len(d.culprits) > 1 and d.improvement is None:
        told.append(f"Which of {len(d.culprits)} mechanisms acts; they change this test alike.")
    elif others:
        told.append(f"Whether there is {' or '.join(others)} as well or instead.")
    if d.library.skipped:
        names = ", ".join(title(name) for name in d.library.skipped)
        told.append(f"Not looked for, since runs are missing: {names}.")
    told.append(_unseen(d))
    return " ".join(told)


def _unseen(d: Diagnosis) -> str:
    """The smallest effects that scatter and noise let one see, as two standard deviations."""
    compared = d.calibration.compared
    covariance = d.library.covariance + compared.noise
    seen = []
    for kinds, words in ((("load", "reload"), "a loading stage"), (("hold",), "a hold")):
        sizes = []
        for place, segment in enumerate(d.protocol.segments):
            own = compared.where(stage=place, channel="strain")
            if segment.kind in kinds and own.any():
                sizes.append(2 * np.sqrt(covariance[np.ix_(own, own)].sum()))
        if sizes:
            least = strain(float(np.median(sizes)) / d.calibration.stiffness)
            seen.append(f"{least} of strain in {words}")
    return f"Effects of less than about {', or '.join(seen)}, are lost in noise and scatter."


def _what_would_tell(d: Diagnosis) -> str:
    if d.next_measurement:
        return f"{d.next_measurement[:1].upper()}{d.next_measurement[1:]}."
    if d.verdict == "unknown":
        return "No measurement can be proposed for something unknown; see where it shows, below."
    return "No further measurement is needed for this verdict."
