"""Tests that a formula answers in place of the DEM."""

from contextlib import contextmanager

import numpy as np

from grus.campaign import Outcome, Run
from grus.card import Card
from grus.record import Record

VERSIONS = {"grus": "0", "yade": "0", "python": "0"}
GRAINS = 10
YIELD = 0.4
"""Yield stress over bond strength."""


class StandIn:
    """Grains whose strengths follow a Weibull law, and specimens that yield and strain by formulas of the card.

    `simulated` has the keys of the runs that were not in a store yet, of which `stored` has the outcomes. After `end` of
    them Ctrl-C is pressed.
    """

    def __init__(self, stored: dict[str, Outcome] | None = None, end: int | None = None) -> None:
        self.stored = {} if stored is None else stored
        self.simulated: list[str] = []
        self.end = end

    def campaign(self, runs, store, jobs, scheduler, progress, tell, client) -> dict[str, Outcome]:
        found = {}
        for run in runs:
            if run.key not in self.stored:
                if self.end is not None and len(self.simulated) >= self.end:
                    raise KeyboardInterrupt
                self.simulated.append(run.key)
                self.stored[run.key] = simulate(run)
            found[run.key] = self.stored[run.key]
            progress(len(found), len(runs))
        return found

    @staticmethod
    @contextmanager
    def workers(jobs, scheduler, tell):
        yield None


def simulate(run: Run) -> Outcome:
    card = run.card
    about = {"key": run.key, "kind": run.kind, "card": card.to_dict(), "grain": run.grain}
    if run.kind == "crush":
        strength = grain_strength(card, run.grain)
        record = Record({"closing": np.arange(2.0)}, {"closing": "m"})
        figures = {"peak.strength": strength, "broken": 1.0}
        return Outcome(**about, record=record, figures=figures, versions=VERSIONS)
    stress = np.geomspace(5e3, 4e5, 40)
    # Specimens of another seed are a little stiffer or softer.
    strain = 1e-9 * stress * 3e9 / float(card.contact.normal_stiffness) * (1 + 0.01 * card.seed)
    channels = {"axial_stress": stress, "axial_strain": strain}
    record = Record(channels, {"axial_stress": "Pa", "axial_strain": "1"})
    figures = {"void_ratio.initial": 0.25}
    if card.bond.tensile_strength < 3e6:
        at = YIELD * float(card.bond.tensile_strength)
        interval = {"yield.interval.0": 0.9 * at, "yield.interval.1": 1.1 * at}
        figures |= {"yield.stress": at, "yield.confidence": 0.95} | interval
    return Outcome(**about, record=record, figures=figures, versions=VERSIONS)


def grain_strength(card: Card, grain: int) -> float:
    """Quantiles of a Weibull law [Pa], whose scale is the bond strength, of GRAINS grains."""
    share = (1 + grain) / (1 + GRAINS)
    modulus = card.bond.scatter.modulus
    return float(card.bond.tensile_strength) * (-np.log(1 - share)) ** (1 / modulus)
