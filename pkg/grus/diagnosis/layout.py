"""What of a recording is compared with a simulation, as one vector of numbers."""

from dataclasses import dataclass, replace

import numpy as np
from scipy.linalg import block_diag

from grus.diagnosis.cells import Cells, cells
from grus.diagnosis.protocol import Protocol
from grus.record import Record, Segment

RATIOS = {"base_stress": "base", "lateral_stress": "lateral"}
"""Channels that are compared as the logarithm of their ratio to the axial stress at the end of each stage."""
LOWEST = 0.03
"""Stress over the highest below which nothing is compared: there a simulation is not at rest, nor a real test."""
END = 0.3
"""Share of a stage's readings that count as its end."""
FEWEST_EVENTS = 10
"""Acoustic events of a test from which they are compared."""
STRAY = 0.01
"""Standard deviation of a hold's share of them that stems from anything but breakage."""


@dataclass(frozen=True)
class Entry:
    """One number: the change of strain over a cell, a ratio of stresses at the end of a stage, or the share of all
    acoustic events that a hold has.

    stage: number in the protocol. kind: of the stage. channel: "strain", "base", "lateral" or "events". start, end: of the cell,
    stress [Pa] or share of the time of a hold.
    """

    stage: int
    kind: str
    channel: str
    start: float
    end: float


@dataclass(frozen=True)
class Layout:
    """parts: cells of each stage. ratios: channel, stage and places of the readings of each ratio of stresses. events:
    stages whose acoustic events are compared. entries: of the vectors (n,). measured: of the recording (n,). noise: covariance of its readings (n, n).
    """

    protocol: Protocol
    parts: tuple[Cells, ...]
    ratios: tuple[tuple[str, int, np.ndarray], ...]
    events: tuple[int, ...]
    entries: tuple[Entry, ...]
    measured: np.ndarray
    noise: np.ndarray

    def of(self, simulated: Record) -> np.ndarray:
        """The same vector (n,) of a simulated test of the same protocol."""
        stages = simulated_stages(simulated, self.protocol.lead)
        values = []
        for part in self.parts:
            values.append(
                part.changes @ _read(simulated, stages[part.stage], part.at, "axial_strain")
            )
        for channel, stage, at in self.ratios:
            top = _read(simulated, stages[stage], at, "axial_stress")
            other = _read(simulated, stages[stage], at, channel)
            values.append([np.mean(np.log(np.maximum(other, 1e-3 * top) / top))])
        values += [[_events(simulated, stages[stage])] for stage in self.events]
        return np.concatenate(values)

    def stiffened(self, factor: float) -> "Layout":
        """The same with all measured strains times a factor."""
        scale = np.where(self.where(channel="strain"), factor, 1.0)
        return replace(
            self, measured=scale * self.measured, noise=scale[:, None] * self.noise * scale
        )

    def where(self, **wanted: str | int) -> np.ndarray:
        """Which entries (n,) have the given stage, kind or channel."""
        return np.array(
            [all(getattr(e, key) == value for key, value in wanted.items()) for e in self.entries]
        )


def layout(record: Record, program: Protocol) -> Layout:
    """Of a recording that has been cut into segments."""
    parts, ratios, entries, measured, variances = [], [], [], [], []
    for stage, segment in enumerate(program.segments):
        lowest = max(program.seating, LOWEST * program.highest)
        jump = program.jump if program.jump and program.jump.stage == stage else None
        part = cells(record, segment, stage, lowest, jump)
        if part is None:
            continue
        parts.append(part)
        changes = part.changes @ record["axial_strain"][part.rows]
        for k in range(len(part)):
            entries.append(Entry(stage, part.kind, "strain", part.knots[k], part.knots[k + 1]))
        measured.append(changes)
        variances.append(part.noise)
    for channel, name in RATIOS.items():
        if channel not in record.channels:
            continue
        for part in parts:
            found = _ratio(record, part, channel)
            if found is None:
                continue
            at, value, variance = found
            ratios.append((channel, part.stage, at))
            entries.append(Entry(part.stage, part.kind, name, part.knots[-2], part.knots[-1]))
            measured.append([value])
            variances.append(np.array([[variance]]))
    heard = _heard(record, parts)
    for part in heard:
        share, number = _events(record, program.segments[part.stage]), _number(record)
        entries.append(Entry(part.stage, part.kind, "events", part.knots[0], part.knots[-1]))
        measured.append([share])
        # Counts, of which one more or less is chance.
        variances.append(np.array([[(share * number + 1) / number**2 + STRAY**2]]))
    noise = block_diag(*variances) if variances else np.zeros((0, 0))
    return Layout(
        program,
        tuple(parts),
        tuple(ratios),
        tuple(part.stage for part in heard),
        tuple(entries),
        np.concatenate(measured) if measured else np.zeros(0),
        noise,
    )


def simulated_stages(simulated: Record, lead: int = 0) -> dict[int, Segment]:
    """Segments of a simulated test by the number of the segment in the protocol; its seating and `lead` come before them.

    A load that goes beyond the highest stress before has two segments there, and one here.
    """
    result: dict[int, Segment] = {}
    for part in simulated.segments:
        number = part.stage - 1 - lead
        if part.kind == "event" or number < 0:
            continue
        first = result.get(number, part)
        result[number] = replace(
            part, first=first.first, t0=first.t0, stress_from=first.stress_from
        )
    return result


def _heard(record: Record, parts: list[Cells]) -> list[Cells]:
    """Holds whose acoustic events are compared."""
    if "ae_events" not in record.channels or _number(record) < FEWEST_EVENTS:
        return []
    heard = np.isfinite(record["ae_events"])
    return [part for part in parts if part.kind == "hold" and heard[part.rows].sum() > 1]


def _number(record: Record) -> float:
    return float(np.nanmax(record["ae_events"]) - np.nanmin(record["ae_events"]))


def _events(record: Record, segment: Segment) -> float:
    """Share of all acoustic events that a stage has; a simulation has one for each bond that breaks."""
    within = record["ae_events"][segment.first : segment.last + 1]
    return float(np.nanmax(within) - np.nanmin(within)) / max(_number(record), 1.0)


def _ratio(record: Record, part: Cells, channel: str) -> tuple[np.ndarray, float, float] | None:
    """Places (n,), mean and variance of the mean of the logarithm of a ratio at the end of a stage."""
    rows = part.rows[-max(int(END * len(part.rows)), 1) :]
    top, other = record["axial_stress"][rows], record[channel][rows]
    good = np.isfinite(other) & (other > 0) & (top > 0)
    if not good.any():
        return None
    values = np.log(other[good] / top[good])
    spread = max(float(np.std(values)), 0.002)
    at = part.at[-len(rows) :][good]
    return at, float(values.mean()), spread**2 / len(values)


def _read(simulated: Record, segment: Segment, at: np.ndarray, channel: str) -> np.ndarray:
    """A channel of a simulated stage at the places of the readings of a recording."""
    rows = segment.rows
    values = simulated[channel][rows]
    if segment.kind == "hold":
        time = simulated["time"][rows] - simulated["time"][rows][0]
        return np.interp(at * time[-1], time, values)
    stress = simulated["axial_stress"][rows]
    if segment.stress_to >= segment.stress_from:
        passed = np.maximum.accumulate(stress)
        return np.interp(at, passed, values)
    passed = -np.minimum.accumulate(stress)
    return np.interp(-at, passed, values)
