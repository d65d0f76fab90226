"""Readings that are missing, and those of the same time."""

from dataclasses import dataclass, field

import numpy as np

from grus.recording.errors import RecordingError

LONGEST_GAP = 5
"""Lines in a row that may lack a reading."""
MOST_MISSING = 0.1
"""Share of all lines that may lack a reading."""
SAME = 0.02
"""Change of stress within one time stamp, as a share of it, beyond which the readings are kept apart."""


@dataclass
class Readings:
    """Channels (n,) in SI with the line of each reading, and notes on what was done to them."""

    source: str
    channels: dict[str, np.ndarray]
    lines: np.ndarray
    notes: list[str] = field(default_factory=list)

    def keep(self, rows: np.ndarray) -> None:
        """Drops all other rows."""
        self.channels = {name: values[rows] for name, values in self.channels.items()}
        self.lines = self.lines[rows]


def drop_missing(readings: Readings, needed: list[str]) -> None:
    """Drops rows without a reading of one of the needed channels; RecordingError when they are too many."""
    lost = np.zeros(len(readings.lines), dtype=bool)
    for name in needed:
        gaps = np.isnan(readings.channels[name])
        first, length = _longest_run(gaps)
        if gaps.all() or length > LONGEST_GAP:
            place = f"line {readings.lines[first]}" if len(gaps) else ""
            reason = f"{name} is missing in {length} lines from here"
            allowed = f"at most {LONGEST_GAP} in a row"
            raise RecordingError.of(readings.source, place, reason, allowed)
        lost |= gaps
    count = int(lost.sum())
    if count > MOST_MISSING * len(lost):
        place = f"line {readings.lines[np.argmax(lost)]}"
        reason = f"{' or '.join(needed)} is missing here and in {count - 1} further lines"
        allowed = f"at most {MOST_MISSING:.0%} of the {len(lost)} lines"
        raise RecordingError.of(readings.source, place, reason, allowed)
    if count:
        readings.keep(~lost)
        readings.notes.append(f"{count} of {len(lost)} lines dropped: no {' or '.join(needed)}")


def _longest_run(mask: np.ndarray) -> tuple[int, int]:
    edges = np.flatnonzero(np.diff(np.concatenate([[0], mask.astype(int), [0]])))
    if not len(edges):
        return 0, 0
    starts, lengths = edges[::2], edges[1::2] - edges[::2]
    longest = int(lengths.argmax())
    return int(starts[longest]), int(lengths[longest])


def merge_stamps(readings: Readings) -> None:
    """Averages readings of one time stamp, but keeps those before and after a step of stress apart.

    RecordingError for a time that falls.
    """
    time, stress = readings.channels["time"], readings.channels["axial_stress"]
    falls = np.flatnonzero(np.diff(time) < 0)
    if len(falls):
        row = int(falls[0]) + 1
        reason = f"the time goes back from {time[row - 1]:.10g} s to {time[row]:.10g} s"
        place = f"line {readings.lines[row]}"
        raise RecordingError.of(readings.source, place, reason, "times that do not fall")
    stepped = np.abs(np.diff(stress)) > SAME * np.maximum(np.abs(stress[1:]), np.abs(stress[:-1]))
    starts = np.flatnonzero(np.concatenate([[True], (np.diff(time) > 0) | stepped]))
    merged = len(time) - len(starts)
    if merged:
        readings.channels = {
            name: _averaged(values, starts) for name, values in readings.channels.items()
        }
        readings.lines = readings.lines[starts]
        readings.notes.append(f"{merged} lines averaged into those before with the same time")


def _averaged(values: np.ndarray, starts: np.ndarray) -> np.ndarray:
    """Mean of the known values of each group, NaN where none is known."""
    known = ~np.isnan(values)
    sums = np.add.reduceat(np.where(known, values, 0.0), starts)
    counts = np.add.reduceat(known.astype(int), starts)
    return np.divide(sums, counts, out=np.full(len(starts), np.nan), where=counts > 0)
