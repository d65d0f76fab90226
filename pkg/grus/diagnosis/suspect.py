"""What may have been left out: known mechanisms by their fingerprints, and what no fingerprint describes."""

from dataclasses import dataclass
from typing import Protocol as Interface

import numpy as np

from grus.diagnosis.fingerprint import Fingerprint
from grus.diagnosis.layout import Layout

LEVEL, SHAPE = 0.4, 0.25
"""Scatter of an effect from stage to stage and from cell to cell of it, as a share: another specimen, another law."""
RATIO, REVERSED = 0.2, 0.6
"""Scatter of a change of stress ratios from stage to stage, as a share: what walls carry follows from one coefficient. More after
unloading: how far the friction of walls has turned round by then depends on the travel that it needs."""
MATTERS = 0.1
"""Effect in a stage over the largest, from which its sign is looked at."""
EVENTS = 0.6
"""Scatter of the share of acoustic events that go with a strain."""
EXACT = 0.03
"""The same of what an instrument does, which depends on no specimen."""
UNKNOWN = {"hold": "strain at constant stress", "ramp": "stiffness", "ratio": "stress ratios"}
SPOKEN = UNKNOWN | {"draining": "strain that lags behind stress, as with pore water"}
"""Where something unknown may show, and what it changes."""
TIMES = (0.005, 0.02, 0.1, 0.4)
"""Characteristic times of unknown courses in a hold, over its length."""
HEARD = 0.3
"""Share of the acoustic events that a hold may have by an unknown cause."""
RAGGED = 3e-4
"""Variance from cell to cell of an unknown course of variance 1."""


class Suspect(Interface):
    """Something that may have been left out.

    name: of the mechanism and its parameter, or "unknown:" and where.
    """

    name: str
    grid: np.ndarray

    def effect(self, size: float) -> tuple[np.ndarray, np.ndarray]:
        """Mean (n,) and covariance (n, n) of the change at a size of the grid."""

    def levels(self, size: float) -> np.ndarray:
        """What one standard deviation of its level in a stage changes (n, m), for each stage in which it matters.

        A level is 1 on average, and cannot be negative: creep is not swelling.
        """


@dataclass(frozen=True)
class Known:
    """A mechanism of the library."""

    fingerprint: Fingerprint
    compared: Layout

    @property
    def name(self) -> str:
        """Of the mechanism, with the parameter and the sign where it has several."""
        one = self.fingerprint
        sign = "-" if one.sign < 0 else ""
        return f"{one.mechanism.name}:{sign}{one.parameter.name}"

    @property
    def grid(self) -> np.ndarray:
        return self.fingerprint.grid()

    def effect(self, size: float) -> tuple[np.ndarray, np.ndarray]:
        change, error = self.fingerprint.at(size)
        exact = self.fingerprint.mechanism.acts_on == "instrument"
        return change, np.diag(error**2) + looseness(self.compared, change, exact)

    def levels(self, size: float) -> np.ndarray:
        change = self.fingerprint.at(size)[0]
        if self.fingerprint.mechanism.acts_on == "instrument":
            return np.zeros((len(change), 0))
        return stage_levels(self.compared, change)

    def of_fingerprint(self, size: float) -> float:
        """Effect of the fingerprint at a size of the grid."""
        return size

    def value(self, size: float) -> float:
        """The parameter at a size of the grid."""
        return self.fingerprint.value(size)

    def bracket(self, size: float) -> tuple[float, ...]:
        """Values of the parameter that an interval holds at least, since the DEM tells no more."""
        return ()

    def outside(self, size: float) -> bool:
        """Whether a size is beyond those that were run."""
        return self.fingerprint.outside(size)


def stage_levels(compared: Layout, change: np.ndarray) -> np.ndarray:
    """What one standard deviation of its level in a stage adds to a change (n,): (n, m) for the m stages where it matters."""
    strain = compared.where(channel="strain")
    parts = [
        _together(compared, change, stage) for stage in sorted({e.stage for e in compared.entries})
    ]
    sizes = np.array([np.abs(part[strain]).sum() for part in parts])
    kept = [p for p, s in zip(parts, sizes) if s > MATTERS * sizes.max()]
    return np.array(kept).reshape(-1, len(change)).T


def _together(compared: Layout, change: np.ndarray, stage: int) -> np.ndarray:
    """What one standard deviation of its level in a stage adds to a change (n,), strain and ratios of stresses together."""
    own = compared.where(stage=stage)
    ratio = REVERSED if (own & compared.where(kind="unload")).any() else RATIO
    share = np.where(compared.where(channel="strain"), LEVEL, ratio)
    return np.where(own & ~compared.where(channel="events"), share * change, 0.0)


def looseness(
    compared: Layout, change: np.ndarray, exact: bool = False, shape: float = SHAPE
) -> np.ndarray:
    """Covariance (n, n) of an effect that should be `change` (n,): another specimen and another law differ somewhat.

    exact: of an instrument, which knows no specimen. shape: scatter from cell to cell, as a share.
    """
    shape = EXACT if exact else shape
    heard = compared.where(channel="events")
    covariance = np.zeros((len(change), len(change)))
    for stage in {e.stage for e in compared.entries}:
        own = compared.where(stage=stage)
        strain = own & compared.where(channel="strain")
        together = _together(compared, change, stage)
        if exact:
            together = np.where(own & ~heard, EXACT * change, 0.0)
        covariance += np.outer(together, together)
        # A cell where little is expected may still have some of what its stage has.
        usual = np.abs(change[strain]).mean() if strain.any() else 0.0
        spread = np.where(strain, shape * np.maximum(np.abs(change), 0.5 * usual), 0.0)
        covariance += np.diag(spread**2)
    return covariance + np.diag(np.where(heard, EVENTS * change, 0.0) ** 2)


@dataclass(frozen=True)
class Unknown:
    """A change of any smooth course, in one kind of entries, of no known cause.

    where: key of UNKNOWN. typical (n,): scale of the changes of strain.
    """

    where: str
    compared: Layout
    typical: np.ndarray

    @property
    def name(self) -> str:
        return f"unknown:{self.where}"

    @property
    def grid(self) -> np.ndarray:
        """Sizes; below 0 for a course in holds that is heard."""
        sizes = np.geomspace(0.02, 1.0, 5)
        heard = self.where == "hold" and self.compared.events
        return np.concatenate([-sizes[::-1], sizes]) if heard else sizes

    def effect(self, size: float) -> tuple[np.ndarray, np.ndarray]:
        n = len(self.compared.entries)
        covariance = np.zeros((n, n))
        if self.where == "ratio":
            ratio = self.compared.where(channel="base") | self.compared.where(channel="lateral")
            return np.zeros(n), np.diag((size * ratio) ** 2)
        if size < 0:
            covariance += np.diag((HEARD * self.compared.where(channel="events")) ** 2)
        for stage in {e.stage for e in self.compared.entries}:
            own = np.flatnonzero(self.compared.where(stage=stage, channel="strain"))
            if not len(own):
                continue
            hold = self.compared.entries[own[0]].kind == "hold"
            if hold != (self.where == "hold"):
                continue
            block = _courses(self.compared, own) if hold else _bends(len(own))
            scale = self._scale(stage, own, hold)
            covariance[np.ix_(own, own)] += size**2 * np.outer(scale, scale) * block
        return np.zeros(n), covariance

    def levels(self, size: float) -> np.ndarray:
        return np.zeros((len(self.compared.entries), 0))

    def _scale(self, stage: int, own: np.ndarray, hold: bool) -> np.ndarray:
        if not hold:
            return self.typical[own]
        # In holds: against the strain of the largest loading stage.
        ramps = self.compared.where(channel="strain") & ~self.compared.where(kind="hold")
        by_stage = [
            self.typical[ramps & self.compared.where(stage=s)].sum()
            for s in {e.stage for e in self.compared.entries}
        ]
        return np.full(len(own), max(by_stage, default=0.0))


def _courses(compared: Layout, own: np.ndarray) -> np.ndarray:
    """Covariance (m, m) of changes over the cells of a hold that settles, creeps, drifts or swells."""
    ends = np.array([[compared.entries[i].start, compared.entries[i].end] for i in own])
    courses = [lambda t, tau=tau: 1 - np.exp(-t / tau) for tau in TIMES]
    courses += [lambda t: t, np.sqrt, lambda t: np.log1p(t / 0.001) / np.log(1e3)]
    rows = np.array([course(ends[:, 1]) - course(ends[:, 0]) for course in courses])
    return rows.T @ rows / len(courses) + RAGGED * np.eye(len(own))


def _bends(m: int) -> np.ndarray:
    """Covariance (m, m) of a smooth factor along a ramp."""
    x = np.linspace(0, 1, m) if m > 1 else np.zeros(1)
    return np.exp(-0.5 * ((x[:, None] - x) / 0.5) ** 2) + RAGGED * np.eye(m)
