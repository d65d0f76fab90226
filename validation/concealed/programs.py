"""Programs of the tests, in the words of a card; shared by many trials, as tests of one laboratory are."""

import re
from dataclasses import dataclass

SEATING = 5.0  # [kPa]

PROGRAMS = {
    "steps": (
        "load to 100 kPa in 0.5 h",
        "load to 200 kPa in 0.5 h",
        "hold for 2 h",
        "load to 400 kPa in 1 h",
        "hold for 24 h",
        "unload to 100 kPa in 0.5 h",
        "hold for 2 h",
        "load to 400 kPa in 0.5 h",
        "load to 600 kPa in 1 h",
        "hold for 24 h",
        "unload to 50 kPa in 0.5 h",
    ),
    "long-hold": (
        "load to 200 kPa in 1 h",
        "hold for 4 h",
        "load to 500 kPa in 1 h",
        "hold for 96 h",
        "unload to 50 kPa in 0.5 h",
        "hold for 24 h",
        "load to 500 kPa in 0.5 h",
        "hold for 4 h",
    ),
    "loops": (
        "load to 300 kPa in 1 h",
        "hold for 12 h",
        "unload to 50 kPa in 0.5 h",
        "load to 300 kPa in 0.5 h",
        "load to 600 kPa in 1 h",
        "hold for 12 h",
        "unload to 100 kPa in 0.5 h",
        "load to 600 kPa in 0.5 h",
        "hold for 12 h",
    ),
    "small": (
        "load to 150 kPa in 1 h",
        "hold for 8 h",
        "load to 400 kPa in 1 h",
        "hold for 48 h",
        "unload to 40 kPa in 0.5 h",
        "hold for 8 h",
        "load to 400 kPa in 0.5 h",
    ),
    "high": (
        "load to 250 kPa in 1 h",
        "hold for 6 h",
        "load to 500 kPa in 1 h",
        "hold for 24 h",
        "unload to 100 kPa in 0.5 h",
        "load to 500 kPa in 0.5 h",
        "load to 1000 kPa in 2 h",
        "hold for 24 h",
        "unload to 100 kPa in 0.5 h",
    ),
    "creep": (
        "load to 100 kPa in 1 h",
        "hold for 8 h",
        "load to 200 kPa in 1 h",
        "hold for 12 h",
        "load to 300 kPa in 1 h",
        "hold for 24 h",
        "load to 400 kPa in 1 h",
        "hold for 48 h",
        "unload to 40 kPa in 0.5 h",
        "hold for 8 h",
    ),
    # A poor one: neither a hold nor a loop, so that much cannot be told.
    "ramp": ("load to 300 kPa in 1 h", "load to 600 kPa in 1 h"),
}


@dataclass(frozen=True)
class Stage:
    """What is done to the specimen: a ramp from `start` to `end` [kPa], or a hold (equal), in `hours`."""

    start: float
    end: float
    hours: float
    virgin: bool  # loading beyond the highest stress before

    @property
    def hold(self) -> bool:
        return self.start == self.end


def stages(program: str) -> tuple[Stage, ...]:
    """The stages of a program of PROGRAMS, from the seating stress on."""
    found: list[Stage] = []
    stress = highest = SEATING
    for words in PROGRAMS[program]:
        hours = float(re.search(r"([\d.]+) h$", words).group(1))
        ramp = re.search(r"to ([\d.]+) kPa", words)
        end = float(ramp.group(1)) if ramp else stress
        found.append(Stage(stress, end, hours, end > highest))
        stress, highest = end, max(highest, end)
    return tuple(found)
