"""A compression curve as a target: from a recording or a table, and that of a simulated test."""

from pathlib import Path
from typing import Any

import numpy as np

from grus.calibrate.fields import fields
from grus.calibrate.targets import CURVE, OEDOMETER, Target
from grus.campaign import Outcome
from grus.card import Card
from grus.card.errors import Problem
from grus.card.interval import POSITIVE, Interval
from grus.card.quantity import Quantity
from grus.card.values import Number
from grus.compression import first_loading
from grus.recording import read

STRESS = Quantity({"Pa": "a stress"}, POSITIVE, "100 kPa")
QUANTITIES = {
    "void_ratio": ("void ratio", Number(POSITIVE)),
    "axial_strain": ("axial strain", Number(Interval(least=0, below=1))),
}
"""Key -> what it is, how a value is read."""
MOST = 20
"""Readings of a recording that are compared; of more, these are interpolated evenly over the logarithm of stress."""


def read_curve(table: Any, card: Card, folder: Path, place: str) -> Target:
    """The target of a table with tolerance and a file, or with tolerance, stress and one of the QUANTITIES.

    folder: that a relative path of the file counts from. place: key of the table in messages.
    Raises Problem, and RecordingError for a file that is no recording.
    """
    readers = {"file": None, "stress": None, "tolerance": Number(POSITIVE)}
    found = fields(table, readers | dict.fromkeys(QUANTITIES), ("tolerance",), place)
    if card.oedometer is None or card.preparation is None:
        raise Problem(
            f"{card.source} has no oedometer test", "a card with [specimen] and [oedometer]", place
        )
    given = [name for name in QUANTITIES if name in found]
    if "file" in found:
        if given or "stress" in found:
            raise Problem("a file and a table", "one of both", place)
        if not isinstance(found["file"], str):
            raise Problem("not a text in quotes", "name of a recording", f"{place}.file")
        name, (stress, values) = "axial_strain", _recorded(folder / found["file"], card, place)
    else:
        if "stress" not in found or len(given) != 1:
            allowed = f"file, or stress and one of {', '.join(QUANTITIES)}"
            raise Problem("no curve", allowed, place)
        name = given[0]
        stress = _column(found["stress"], STRESS, f"{place}.stress")
        values = _column(found[name], QUANTITIES[name][1], f"{place}.{name}")
        _check(stress, values, name, card, place)
    what = QUANTITIES[name][0]
    return Target(CURVE, OEDOMETER, what, "1", tuple(values), found["tolerance"], tuple(stress))


def of_test(outcome: Outcome, target: Target) -> np.ndarray:
    """What a simulated test has at the stresses of the target (k,), on first loading."""
    record = outcome.record
    used = first_loading(record["axial_stress"])
    places, strains = np.log(record["axial_stress"][used]), record["axial_strain"][used]
    strain = np.interp(np.log(target.stress), places, strains)
    if target.quantity == QUANTITIES["void_ratio"][0]:
        return (1 + outcome.figures["void_ratio.initial"]) * (1 - strain) - 1
    return from_first(strain)


def from_first(strain: np.ndarray) -> np.ndarray:
    """Strains (k,) counted from the first: where a test has its zero is a matter of the laboratory."""
    return (strain - strain[0]) / (1 - strain[0])


def _column(values: Any, reader: Any, place: str) -> list[float]:
    if not isinstance(values, list):
        raise Problem("not a list", f"a list, each {reader.allowed}", place)
    found = []
    for number, value in enumerate(values, start=1):
        try:
            found.append(float(reader.read(value)))
        except Problem as problem:
            raise Problem(f"value {number}: {problem.reason}", problem.allowed, place) from None
    return found


def _check(stress: list[float], values: list[float], name: str, card: Card, place: str) -> None:
    fewest = 2 if name == "axial_strain" else 1  # strains are counted from the first
    if not len(stress) == len(values) >= fewest:
        reason = f"{len(stress)} stresses and {len(values)} values"
        raise Problem(reason, f"as many of both, {fewest} or more", place)
    if (np.diff(stress) <= 0).any():
        raise Problem(
            "stresses that do not rise", "first loading, each above the one before", place
        )
    low, high = _reach(card)
    if stress[0] < low or stress[-1] > high:
        reason = f"from {stress[0]:g} to {stress[-1]:g} Pa, of which {card.source} tests {low:g} to {high:g} Pa"
        raise Problem(reason, "stresses that the stages of the card reach", f"{place}.stress")


def _reach(card: Card) -> tuple[float, float]:
    """Stresses [Pa] between which the card's test loads."""
    highest = max(stage.stress for stage in card.oedometer.stages if stage.kind == "load")
    return float(card.preparation.seating_stress), float(highest)


def _recorded(path: Path, card: Card, place: str) -> tuple[list[float], list[float]]:
    """Stress [Pa] and strain, counted from the first, of the first loading within the card's reach."""
    record = read(path)
    low, high = _reach(card)
    stress, strain = record["axial_stress"], record["axial_strain"]
    used = first_loading(stress) & (stress >= low) & (stress <= high)
    if used.sum() < 2:
        reason = f"{used.sum()} readings of first loading from {low:g} to {high:g} Pa"
        raise Problem(reason, "two or more", f"{place}.file")
    stress, strain = stress[used], strain[used]
    if len(stress) > MOST:
        even = np.geomspace(stress[0], stress[-1], MOST)
        stress, strain = even, np.interp(np.log(even), np.log(stress), strain)
    return stress.tolist(), from_first(strain).tolist()
