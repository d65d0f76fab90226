"""The channels of a recording: names, units, synonyms."""

import re
from dataclasses import dataclass


@dataclass(frozen=True)
class Channel:
    """One channel: its name, SI unit, what it measures, an example of a header, and further names that are read."""

    name: str
    unit: str
    what: str
    example: str
    synonyms: tuple[str, ...] = ()


CHANNELS = (
    Channel("time", "s", "a time", "time [h]", ("t", "elapsed time", "timestamp", "date time")),
    Channel(
        "axial_stress",
        "Pa",
        "a stress",
        "axial_stress [kPa]",
        ("vertical stress", "stress", "sigma", "sigma_a", "sigma_v", "sigma_1"),
    ),
    Channel(
        "axial_strain",
        "1",
        "a strain",
        "axial_strain [%]",
        ("vertical strain", "strain", "epsilon", "epsilon_a", "epsilon_1", "eps_a", "eps_1"),
    ),
    Channel(
        "settlement",
        "m",
        "a length",
        "settlement [mm]",
        ("displacement", "axial displacement", "vertical displacement", "compression"),
    ),
    Channel("base_stress", "Pa", "a stress", "base_stress [kPa]", ("bottom stress",)),
    Channel(
        "lateral_stress",
        "Pa",
        "a stress",
        "lateral_stress [kPa]",
        ("horizontal stress", "radial stress", "side stress", "sigma_h", "sigma_r"),
    ),
    Channel("ae_events", "1", "a count", "ae_events", ("ae", "ae hits", "acoustic emission")),
    Channel("temperature", "K", "a temperature", "temperature [degC]", ("temp",)),
    Channel("humidity", "1", "a relative humidity", "humidity [%]", ("relative humidity", "rh")),
)


def key(name: str) -> str:
    """A name without the differences that do not matter: case, spaces, hyphens, underscores."""
    return re.sub(r"[\s_-]+", "", name).casefold()


BY_KEY = {key(name): channel for channel in CHANNELS for name in (channel.name, *channel.synonyms)}
