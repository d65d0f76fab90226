"""Recordings and simulations made by formulas, for tests that need no DEM."""

import numpy as np

from grus.diagnosis.layout import Layout, layout
from grus.diagnosis.protocol import protocol
from grus.record import Record, Segment

KPA = 1e3
STAGES = (
    ("load", 5, 200),
    ("hold", 200, 200),
    ("load", 200, 500),
    ("hold", 500, 500),
    ("unload", 500, 50),
)
HOUR = 3600.0


def made_test(
    rows: int = 60,
    creep: float = 0.0,
    drift: float = 0.0,
    noise: float = 0.0,
    modulus: float = 3e8,
    seed: int = 1,
    base: float | None = None,
) -> Record:
    """A test of two loads, two holds of a day and an unloading: strain [-] stress/modulus, twice as stiff on unloading.

    creep: strain in a decade of time at 500 kPa, proportional to the square of stress. drift: strain in a second.
    base: stress at the base over that at the top.
    """
    time, stress, strain, segments = [0.0], [5 * KPA], [0.0], []
    for number, (kind, low, high) in enumerate(STAGES, start=1):
        first, begin, at = len(time) - 1, time[-1], strain[-1]
        if kind == "hold":
            passed = np.geomspace(1.0, 24 * HOUR, rows)
            level = np.full(rows, high * KPA)
            more = creep * (high / 500) ** 2 * np.log10(1 + passed / 60)
        else:
            passed = np.linspace(0, HOUR, rows + 1)[1:]
            level = KPA * (low + (high - low) * passed / HOUR)
            more = (level - low * KPA) / modulus / (2 if kind == "unload" else 1)
        time += list(begin + passed)
        stress += list(level)
        strain += list(at + more)
        segments.append(
            (kind, number, first, len(time) - 1, begin, time[-1], low * KPA, high * KPA)
        )
    clock = np.array(time)
    generator = np.random.default_rng(seed)
    read = np.array(strain) + drift * clock + noise * generator.standard_normal(len(clock))
    channels = {"time": clock, "axial_stress": np.array(stress), "axial_strain": read}
    units = {"time": "s", "axial_stress": "Pa", "axial_strain": "1"}
    if base is not None:
        channels["base_stress"], units["base_stress"] = base * np.array(stress), "Pa"
    cut = tuple(Segment(*s, noise={"axial_strain": max(noise, 1e-7)}) for s in segments)
    return Record(channels, units, {"height": 0.08}, cut)


def compared(record: Record) -> Layout:
    """The layout of a record."""
    return layout(record, protocol(record))
