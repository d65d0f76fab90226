"""Cutting a record into seating, loading, holds, unloading, reloading and events."""

from collections.abc import Sequence

import numpy as np

from grus.card.program import Stage
from grus.errors import GrusError
from grus.record import Record, Segment
from grus.recording.alignment import aligned_parts, read_program
from grus.recording.events import find_jumps
from grus.recording.noise import FEWEST, noise_level
from grus.recording.parts import Part, find_parts
from grus.recording.path import StressPath


def segments(record: Record, program: Sequence[str | Stage] | None = None) -> tuple[Segment, ...]:
    """Segments of a test by its `axial_stress` [Pa], and its `time` [s] if it has one.

    program: stages in the words of a card ("load to 100 kPa", "hold for 24 h") or as a card holds them; without one
    the stages are told from the stress alone, and numbered as they are found. Events are jumps of `axial_strain`; each
    follows the segment it lies in.

    Raises GrusError without a channel `axial_stress`, for stresses or times that are not finite, times that fall, less
    than two rows, a program that is none, and one that the record does not follow.
    """
    stress, x = _columns(record)
    path = StressPath.of(stress, x)
    if program is None:
        parts = find_parts(stress, x, path)
    else:
        parts = aligned_parts(stress, x, path, read_program(program))
    overall = _noise(record, path, slice(None))
    result = []
    for part in parts:
        own = slice(part.first, part.last + 1)
        noise = _noise(record, path, own) if part.last - part.first + 1 >= 2 * FEWEST else overall
        result.append(_segment(record, part, noise))
        result += [_segment(record, event, noise) for event in _events(record, part, path)]
    return tuple(result)


def _columns(record: Record) -> tuple[np.ndarray, np.ndarray]:
    """Stress (n,) [Pa] and the places of the readings (n,) from 0 to 1: times, or rows without a time."""
    if "axial_stress" not in record.channels:
        raise GrusError("record channel axial_stress is missing; allowed: a record with a stress")
    if len(record) < 2:
        raise GrusError(f"record rows = {len(record)}; allowed: two or more")
    stress = np.asarray(record["axial_stress"], dtype=float)
    x = np.asarray(record.channels.get("time", np.arange(len(stress))), dtype=float)
    for name, column in (("axial_stress", stress), ("time", x)):
        if not np.isfinite(column).all():
            row = int(np.flatnonzero(~np.isfinite(column))[0])
            raise GrusError(f"record {name} = {column[row]} in row {row}; allowed: finite numbers")
    if (np.diff(x) < 0).any():
        row = int(np.flatnonzero(np.diff(x) < 0)[0]) + 1
        raise GrusError(f"record time = {x[row]:g} s in row {row}: falls; allowed: rising times")
    # Of order one, since times may be of any.
    return stress, (x - x[0]) / (np.ptp(x) or 1.0)


def _noise(record: Record, path: StressPath, rows: slice) -> dict[str, float]:
    """Standard deviation of a reading of each channel but the time, where it has enough readings."""
    result = {}
    for name, values in record.channels.items():
        known = np.flatnonzero(np.isfinite(values[rows]))
        if name != "time" and len(known) >= FEWEST:
            result[name] = noise_level(np.asarray(values[rows][known], dtype=float), known * 1.0)
    result["axial_stress"] = float(np.median(path.noise[rows]))
    return result


def _events(record: Record, part: Part, path: StressPath) -> list[Part]:
    strain = record.channels.get("axial_strain")
    if strain is None or not np.isfinite(strain[part.first : part.last + 1]).all():
        return []
    rows = np.arange(part.first, part.last + 1)
    if part.start != part.end:
        along = path.at(rows)
    else:
        along = record.channels.get("time", np.arange(len(record)) * 1.0)[rows]
    jumps = find_jumps(strain[rows], along)
    stress = path.at(rows)
    return [
        Part("event", part.stage, int(rows[a]), int(rows[b]), float(stress[a]), float(stress[b]))
        for a, b in jumps
    ]


def _segment(record: Record, part: Part, noise: dict[str, float]) -> Segment:
    time = record.channels.get("time")
    return Segment(
        kind=part.kind,
        stage=part.stage,
        first=part.first,
        last=part.last,
        t0=None if time is None else float(time[part.first]),
        t1=None if time is None else float(time[part.last]),
        stress_from=part.start,
        stress_to=part.end,
        noise=dict(noise),
    )
