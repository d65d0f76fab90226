"""Outcome of an oedometer test."""

from dataclasses import dataclass

import numpy as np

from grus.card import Card
from grus.preparation import PreparedSpecimen
from grus.record import Record
from grus.scene import Contacts, Snapshot

SEAT = "seat"


def stage_name(kind: str, stress: float) -> str:
    """As in "load to 100 kPa"; stress [Pa]."""
    return f"{kind} {'to' if kind in ('load', 'unload') else 'at'} {stress / 1e3:g} kPa"


@dataclass(frozen=True)
class StageEnd:
    """The specimen at rest at the end of a stage.

    number: from 0, which is the seating. kind: 'seat', 'load', 'unload', 'hold' or 'wet'. target: axial stress [Pa].
    height [m]; void_ratio by the outlines of the grains [-]; axial_stress and side_stress [Pa]; tension_breaks and
    shear_breaks: bonds broken since the start; steps: of the whole test so far. state: elements and bonds. contacts: with their
    forces.
    """

    number: int
    kind: str
    target: float
    height: float
    void_ratio: float
    axial_stress: float
    side_stress: float
    tension_breaks: int
    shear_breaks: int
    steps: int
    state: Snapshot
    contacts: Contacts

    @property
    def K0(self) -> float:
        """Side stress over axial stress [-]."""
        return self.side_stress / self.axial_stress

    @property
    def name(self) -> str:
        """As in "load to 100 kPa"."""
        return stage_name(self.kind, self.target)

    @property
    def breaks(self) -> int:
        """Bonds broken since the start."""
        return self.tension_breaks + self.shear_breaks


@dataclass(frozen=True)
class OedometerResult:
    """Record and stages of a test; the first stage is the seating, whose end all strains and void ratios refer to.

    rests: records on the laboratory clock, in holds and at delayed failures; empty when bonds do not change with time.
    """

    card: Card
    prepared: PreparedSpecimen
    bonds: int
    record: Record
    stages: tuple[StageEnd, ...]
    rests: Record = Record({}, {})

    @property
    def seated(self) -> StageEnd:
        """The specimen before the test."""
        return self.stages[0]

    @property
    def stress(self) -> np.ndarray:
        """Axial stress (n,) of the record [Pa], the mean of both platens."""
        return (self.record["top_stress"] + self.record["bottom_stress"]) / 2

    @property
    def void_ratio(self) -> np.ndarray:
        """Void ratio (n,) of the record by the outlines of the grains [-]."""
        volume_of_height = self.prepared.box_volume / self.prepared.height
        return volume_of_height * self.record["height"] / self.prepared.outline_volume - 1

    @property
    def broken(self) -> np.ndarray:
        """Bonds broken (n,) of the record since the start."""
        return self.record["tension_breaks"] + self.record["shear_breaks"]

    @property
    def energy_error(self) -> np.ndarray:
        """Work that no energy accounts for (n,), over the energy at the start and the largest work so far [-]."""
        r = self.record
        stored = r["elastic_energy"] + r["kinetic_energy"]
        # Contacts are under load from the start, and coming to rest before has taken energy.
        spent = stored + r["released_energy"] + r["sliding_work"] + r["damped_energy"]
        spent = spent - spent[0]
        most = stored[0] + np.maximum.accumulate(np.abs(r["work"]))
        return np.divide(r["work"] - spent, most, out=np.zeros_like(most), where=most > 0)
