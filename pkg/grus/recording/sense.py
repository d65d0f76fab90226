"""Recordings that make no sense are refused."""

import numpy as np

from grus.recording.clean import Readings
from grus.recording.errors import RecordingError

LOWEST, HIGHEST = 1.0, 1e11
"""Bounds of the highest axial stress of a test [Pa]."""
BELOW_ZERO = 0.05
"""Most a stress may be below zero, as a share of the highest: an offset of the instrument."""
RISE = 0.5
"""Rise of stress, as a share of the highest, over which the strain is compared with it."""
AGAINST = 0.2
"""Fall of the strain over this rise, as a share of its range, beyond which one of them has the wrong sign."""
SMALL = 3e-3
"""Largest strain, given in per cent, below which a note asks whether it is a fraction."""


def check(readings: Readings, strain_unit: str) -> None:
    """Refuses readings that cannot be a test; notes what may be a slip. strain_unit: as in the header."""
    stress, strain = readings.channels["axial_stress"], readings.channels["axial_strain"]
    if len(stress) < 2:
        _refuse(readings, f"{len(stress)} readings", "two or more")
    if np.ptp(strain) == 0:
        _refuse(readings, f"all {len(strain)} strains are {strain[0]:g}", "strains that change")
    top = float(stress.max())
    if not LOWEST <= top <= HIGHEST:
        reason = f"the highest axial stress is {top:.4g} Pa"
        _refuse(readings, reason, f"{LOWEST:g} to {HIGHEST:g} Pa, compression positive")
    if stress.min() < -BELOW_ZERO * top:
        row = int(stress.argmin())
        reason = f"axial stress {stress[row]:.4g} Pa"
        allowed = f"compression positive, at most {BELOW_ZERO:.0%} of the highest below zero"
        _refuse(readings, reason, allowed, row)
    largest = int(np.abs(strain).argmax())
    if abs(strain[largest]) > 1:
        value = strain[largest]
        reason = f"axial strain {value:.4g} (that is {100 * value:.4g} %)"
        _refuse(readings, reason, 'at most 1; per cent are written "axial_strain [%]"', largest)
    end = int(stress.argmax())
    start = int(stress[: end + 1].argmin())
    # Creep may go on while the stress falls: only the rise to the highest stress tells the sign.
    if stress[end] - stress[start] > RISE * top:
        if strain[end] - strain[start] < -AGAINST * np.ptp(strain):
            _refuse(
                readings, "the strain falls where the stress grows", "compression positive in both"
            )
    if strain_unit in ("%", "percent") and np.abs(strain).max() < SMALL:
        largest = 100 * np.abs(strain).max()
        readings.notes.append(
            f"the largest strain is {largest:.2g} %; fractions would be axial_strain [-]"
        )
    _check_others(readings)


def _check_others(readings: Readings) -> None:
    bounds = {"humidity": (0.0, 1.0, "0 to 100 %"), "temperature": (1.0, 3000.0, "1 to 3000 K")}
    bounds |= {"ae_events": (0.0, 1e15, "0 or more")}
    for name, (low, high, allowed) in bounds.items():
        values = readings.channels.get(name)
        if values is None:
            continue
        off = np.flatnonzero((values < low) | (values > high))
        if len(off):
            _refuse(readings, f"{name} {values[off[0]]:.6g}", allowed, int(off[0]))


def _refuse(readings: Readings, reason: str, allowed: str, row: int | None = None) -> None:
    place = "" if row is None else f"line {readings.lines[row]}"
    raise RecordingError.of(readings.source, place, reason, allowed)
