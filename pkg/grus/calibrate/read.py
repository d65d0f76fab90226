"""Reading a file of targets."""

from collections.abc import Iterator, Mapping
from os import PathLike
from pathlib import Path
from typing import Any

from grus.calibrate.curve import read_curve
from grus.calibrate.fields import fields
from grus.calibrate.parameter import Parameter
from grus.calibrate.targets import CRUSH, CURVE, OEDOMETER, Target, Targets
from grus.campaign import Run
from grus.card import Card
from grus.card.errors import CardError, Problem
from grus.card.interval import POSITIVE
from grus.card.quantity import Measure, Quantity
from grus.card.toml_file import read as read_toml
from grus.card.unknown import schema
from grus.card.values import Flag, Number, Whole
from grus.errors import GrusError

STRESS = Quantity({"Pa": "a stress"}, POSITIVE, "1.2 MPa")
SINGLE = {
    "weibull_modulus": (CRUSH, "Weibull modulus", Number(POSITIVE)),
    "characteristic_strength": (CRUSH, "characteristic strength", STRESS),
    "yield_stress": (OEDOMETER, "yield stress", STRESS),
    "breakage_onset": (OEDOMETER, "onset of sustained breakage", STRESS),
}
"""Targets of one value: name -> kind of test, what it is, how it is read."""
FEWEST_GRAINS, GRAINS = 5, 30
MOST = 10_000
"""Grains or specimens of a trial."""


def read_targets(path: str | PathLike, card: Card) -> Targets:
    """Targets in a TOML file, for the calibration of `card`.

    Raises GrusError, in one line that names file and key, when the file or anything in it is wrong, or when the card
    cannot show a target.
    """
    source, folder = str(path), Path(path).parent
    tables = read_toml(path, "a file of targets")
    readers = {
        "grains": Whole(FEWEST_GRAINS, MOST),
        "specimens": Whole(1, MOST),
        "parameters": None,
        "targets": None,
    }
    try:
        found = fields(tables, readers, needed=("parameters", "targets"))
        parameters = tuple(_parameters(found["parameters"], card))
        targets = tuple(_targets(found["targets"], card, folder))
    except Problem as problem:
        raise CardError.of(source, [problem], tables) from None
    made = Targets(
        source, parameters, targets, found.get("grains", GRAINS), found.get("specimens", 1)
    )
    _check_card(card, made)
    return made


def _parameters(table: Any, card: Card) -> Iterator[Parameter]:
    """In the order of the file. Raises Problem."""
    known = {
        name: key.reader for name, key in schema(Card) if isinstance(key.reader, (Quantity, Number))
    }
    found = dict(_leaves(table, "parameters"))
    if not found:
        raise Problem("no key to fit", "one key of the card or more", "parameters")
    taken: set[str] = set()
    for name, bounds in found.items():
        place = f"parameters.{name}"
        parameter = _parameter(name, bounds, place, known)
        for one in (name, *parameter.tied):
            if one not in known:
                raise Problem(f"{one} is no key of a card that holds a number", ALLOWED, place)
            if one in taken:
                raise Problem(f"{one} is fitted twice", "each key once", place)
            taken.add(one)
        yield parameter


ALLOWED = "keys that `grus card --explain` shows with numbers, as bond.tensile_strength"


def _leaves(table: Any, parent: str) -> Iterator[tuple[str, Mapping]]:
    """Tables of bounds by their dotted names."""
    if not isinstance(table, Mapping):
        raise Problem(
            "not a table", 'as bond.tensile_strength = {low = "1 MPa", high = "3 MPa"}', parent
        )
    for name, value in table.items():
        if isinstance(value, Mapping) and not {"low", "high"} & set(value):
            yield from (
                (f"{name}.{rest}", leaf) for rest, leaf in _leaves(value, f"{parent}.{name}")
            )
        else:
            yield name, value


def _parameter(name: str, bounds: Any, place: str, known: Mapping[str, Any]) -> Parameter:
    if name not in known:
        raise Problem("no key of a card that holds a number", ALLOWED, place)
    readers = {"low": known[name], "high": known[name], "logarithmic": Flag(), "tied": None}
    found = fields(bounds, readers, needed=("low", "high"), parent=place)
    low, high = found["low"], found["high"]
    units = {value.unit for value in (low, high) if isinstance(value, Measure)}
    if len(units) > 1:
        raise Problem(f"bounds in {' and '.join(sorted(units))}", "one kind of unit", place)
    logarithmic, tied = found.get("logarithmic", False), found.get("tied", [])
    if not low < high:
        raise Problem(f"from {low:g} to {high:g}", "low below high", place)
    if logarithmic and low <= 0:
        raise Problem(f"from {low:g}, which has no logarithm", "low above 0", place)
    if not isinstance(tied, list) or not all(isinstance(one, str) for one in tied):
        raise Problem("not a list of keys", 'as ["bond.shear_strength"]', f"{place}.tied")
    unit = "".join(units)
    return Parameter(name, float(low), float(high), unit, logarithmic, tuple(tied))


def _targets(table: Any, card: Card, folder: Path) -> Iterator[Target]:
    """In the order of the file. Raises Problem."""
    found = fields(table, dict.fromkeys((*SINGLE, CURVE)), parent="targets")
    if not found:
        raise Problem("no target", f"one of {', '.join((*SINGLE, CURVE))}, or more", "targets")
    for name, value in found.items():
        place = f"targets.{name}"
        if name == CURVE:
            yield read_curve(value, card, folder, place)
            continue
        kind, quantity, reader = SINGLE[name]
        readers = {"value": reader, "tolerance": reader}
        given = fields(value, readers, needed=("value", "tolerance"), parent=place)
        unit = getattr(given["value"], "unit", "1")
        yield Target(
            name, kind, quantity, unit, (float(given["value"]),), float(given["tolerance"])
        )


def _check_card(card: Card, targets: Targets) -> None:
    """Whether the card has what the tests need, and takes the bounds, one parameter at a time."""
    for kind in (CRUSH, OEDOMETER):
        if targets.of(kind):
            Run(kind, card)
    for parameter in targets.parameters:
        for name in ("low", "high"):
            value = getattr(parameter, name)
            try:
                card.with_overrides(parameter.overrides(value))
            except CardError as error:
                raise GrusError(
                    f"{targets.source}: parameters.{parameter.name}.{name}: {error}"
                ) from None
