"""Tables of the page: rows of text under headers."""

from collections.abc import Sequence
from dataclasses import dataclass

from grus.diagnosis.base import Base
from grus.diagnosis.diagnosis import Diagnosis
from grus.diagnosis.improvement import Fit
from grus.diagnosis.predict import Error
from grus.diagnosis.report.spoken import number, probability, quantity, strain
from grus.diagnosis.report.stages import numbers
from grus.diagnosis.report.words import foreseen
from grus.mechanisms import MECHANISMS


@dataclass(frozen=True)
class Table:
    """header: of the columns. rows: a text a column."""

    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


def sizes(d: Diagnosis) -> Table:
    """Parameters of the mechanisms that are named or cannot be told apart."""
    rows = []
    for culprit in d.culprits:
        known = {p.name: p for p in MECHANISMS[culprit.name].parameters}
        for one in culprit.parameters:
            interval = f"{quantity(one.low, one.unit)} to {quantity(one.high, one.unit)}"
            beyond = " (beyond the values that were run)" if one.outside else ""
            words = (culprit.title, probability(culprit.probability), one.name.replace("_", " "))
            value = quantity(one.value, one.unit) + beyond
            rows.append((*words, value, interval, known[one.name].meaning))
    header = ("mechanism", "probability", "parameter", "value", "90 % interval", "what it is")
    return Table(header, tuple(rows))


def errors(d: Diagnosis) -> Table:
    """Before and after the mechanisms were put back."""
    fit, scale = d.improvement, d.calibration.stiffness
    out = numbers(d, fit.left_out)
    of = {
        f"{out}, {foreseen(fit)}": lambda one: one.left_out,
        f"{out}, after all were seen": lambda one: one.where_it_acts,
        "all stages, after all were seen": lambda one: one.overall,
    }
    rows = tuple((words, *_pair(fit.before, fit.after, get, scale)) for words, get in of.items())
    header = (
        "",
        "error of strain before",
        "after",
        "times smaller",
        "χ² per number before",
        "after",
    )
    return Table(header, rows)


def _pair(before: Fit, after: Fit, get, scale: float) -> tuple[str, ...]:
    a, b = get(before), get(after)
    return (*_strains(a, b, scale), number(a.chi2_dof), number(b.chi2_dof))


def _strains(before: Error, after: Error, scale: float) -> tuple[str, str, str]:
    less = number(before.rmse_strain / after.rmse_strain) if after.rmse_strain > 0 else "–"
    return strain(before.rmse_strain / scale), strain(after.rmse_strain / scale), less


def calibration(d: Diagnosis) -> Table:
    """Ordinary parameters before and after calibration."""
    scale, highest = d.stiffness, d.protocol.highest
    strength = d.calibration.base.strength_factor(d.small, highest)
    contact, bond = d.small.contact, d.small.bond
    stiffnesses = {
        "contact, normal": contact.normal_stiffness,
        "bond, normal": bond.normal_stiffness,
    }
    rows = [
        (f"stiffness of {name}", _si(value), _si(scale * value, value.unit))
        for name, value in stiffnesses.items()
        if value is not None
    ]
    tensile = float(bond.tensile_strength)
    rows.append(
        ("tensile strength of bonds", quantity(tensile, "Pa"), quantity(strength * tensile, "Pa"))
    )
    friction = contact.friction_coefficient
    rows.append(
        ("friction coefficient", number(friction), number(friction * d.calibration.base.friction))
    )
    return Table(("parameter", "card", "calibrated"), tuple(rows))


def _si(value: float, unit: str = "") -> str:
    return f"{float(value):.3g} {unit or value.unit}"


def runs(d: Diagnosis) -> Table:
    """What was simulated, with which values, on which specimens."""
    seeds = _listed([str(seed) for seed in d.library.plain])
    rows = [
        ("calibration", f"tensile strength of bonds {_tried(d)}", "the first of these"),
        ("calibrated base", "", f"seeds {seeds}"),
    ]
    for one in d.library.fingerprints:
        values = _listed([quantity(one.sign * size, one.parameter.unit) for size in one.sizes])
        name = one.parameter.name.replace("_", " ")
        rows.append((f"fingerprint: {one.mechanism.title}", f"{name} {values}", "some of these"))
    rows += [(f"missing: {MECHANISMS[k].title}", why, "") for k, why in d.library.skipped.items()]
    if d.improvement is not None:
        for culprit in d.culprits:
            values = _listed(
                [
                    f"{p.name.replace('_', ' ')} {quantity(p.value, p.unit)}"
                    for p in culprit.parameters
                ]
            )
            rows.append(
                (f"put back: {culprit.title}", values, f"{d.improvement.specimens} of these")
            )
    return Table(("run", "values", "specimens"), tuple(rows))


def _tried(d: Diagnosis) -> str:
    tensile, highest = float(d.small.bond.tensile_strength), d.protocol.highest
    factors = [Base(step).strength_factor(d.small, highest) for step, _ in d.calibration.tried]
    return _listed([quantity(factor * tensile, "Pa") for factor in factors])


def _listed(words: Sequence[str]) -> str:
    return ", ".join(words)
