"""Compliance of platens, load cell and frame, and the closing of a gap at the platens."""

from dataclasses import replace

import numpy as np

from grus.errors import GrusError
from grus.mechanisms.mechanism import Mechanism, Parameter, Values
from grus.record import Record


def closing(stress: np.ndarray, values: Values) -> np.ndarray:
    """Shortening (n,) [m] of what is in series with the specimen under an axial stress (n,) [Pa].

    A spring, and a gap that closes exponentially as that of a rock joint (Malama & Kulatilake 2003); both are elastic.
    """
    gap = -np.expm1(-np.maximum(stress, 0.0) / values["toe_stress"])
    return values["compliance"] * stress + values["closure"] * gap


def _distort(record: Record, values: Values) -> Record:
    if "height" not in record.meta:
        raise GrusError(
            "record meta: no height; allowed: a record with the height of the specimen [m]"
        )
    shortening = closing(record["axial_stress"], values)
    zero = next((one.last for one in record.segments if one.kind == "seat"), 0)
    strain = (shortening - shortening[zero]) / float(record.meta["height"])
    changed = record.channels | {"axial_strain": record["axial_strain"] + strain}
    return replace(record, channels=changed)


MECHANISM = Mechanism(
    name="platen_compliance",
    title="Compliance of platens and seating",
    acts_on="test",
    parameters=(
        Parameter(
            "compliance",
            "m/Pa",
            low=1e-13,
            high=1e-8,
            sizes=(1e-11, 5e-11, 2e-10),
            logarithmic=True,
            meaning="Shortening of platens, load cell and frame under a unit of axial stress.",
            off=0.0,
        ),
        Parameter(
            "closure",
            "m",
            low=0.0,
            high=1e-2,
            sizes=(0.0, 2e-5),
            logarithmic=False,
            meaning="Gap between platens and specimen that closes under load.",
            off=0.0,
        ),
        Parameter(
            "toe_stress",
            "Pa",
            low=1e2,
            high=1e7,
            sizes=(2e4,),
            logarithmic=True,
            meaning="Axial stress at which all but 1/e of the gap has closed.",
        ),
    ),
    summary="The settlement that is measured contains that of platens, load cell and seating, so that the specimen seems softer, at the "
    "beginning of loading above all.",
    signs="Extra strain that depends on the stress alone, comes back in full on unloading, and does not grow with time; stiffness of "
    "unloading and reloading too low by the same amount.",
    on_record=_distort,
)
