"""Stored figures against new ones."""

import json
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from os import environ
from pathlib import Path

HERE = Path(__file__).resolve().parent
STORED = HERE / "figures.json"
THREADS = ("1", "2")

ROUNDING = 1e-6
"""Relative difference on one thread, where a run repeats itself bit by bit on one machine: room for the mathematical
functions of another one. Whole numbers are equal."""
LOOSE = {"axial_stress": 0.01, "height": 1e-4, "K0": 0.05, "void_ratio": ROUNDING}
"""Relative differences on several threads, which add up forces in another order from run to run; a stage ends anywhere
within its tolerance of 1 %, and what breaks then spreads the difference."""
LOOSE_OTHERS = 0.05
LOOSE_COUNT, LOOSE_SHARE = 2, 0.1
"""Whole numbers there: so many, or this share of them."""


@dataclass(frozen=True)
class Difference:
    """A figure that is not as stored; None where there is none."""

    name: str
    stored: float | None
    found: float | None

    def __str__(self) -> str:
        change = ""
        if self.stored and self.found is not None:
            change = f" ({100 * (self.found / self.stored - 1):+.3g} %)"
        return f"{self.name}: {self.stored} -> {self.found}{change}"


def compute(threads: str, specimens: Path) -> dict:
    """The figures, from a process with so many threads."""
    command = [sys.executable, str(HERE / "figures.py"), str(specimens)]
    done = subprocess.run(
        command, env=environ | {"OMP_NUM_THREADS": threads}, stdout=subprocess.PIPE, check=True
    )
    return json.loads(done.stdout)


def flat(figures: dict, name: str = "") -> dict[str, float]:
    """Figures by their whole names, in order."""
    result = {}
    for key, value in figures.items():
        inner = f"{name}, {key}" if name else key
        result |= flat(value, inner) if isinstance(value, dict) else {inner: value}
    return result


def differences(stored: dict, found: dict, tolerant: bool | None = None) -> Iterator[Difference]:
    """What differs: at all, beyond rounding (tolerant False), or beyond what several threads may (True)."""
    old, new = flat(stored), flat(found)
    for name in [*old, *(name for name in new if name not in old)]:
        a, b = old.get(name), new.get(name)
        if a is None or b is None or not _close(name.rpartition(", ")[2], a, b, tolerant):
            yield Difference(name, a, b)


def _close(name: str, a: float, b: float, tolerant: bool | None) -> bool:
    if tolerant is None:
        return a == b
    whole = isinstance(a, int) and isinstance(b, int)
    if not tolerant:
        return a == b if whole else abs(b - a) <= ROUNDING * abs(a)
    if whole:
        return abs(b - a) <= max(LOOSE_COUNT, LOOSE_SHARE * a)
    return abs(b - a) <= LOOSE.get(name, LOOSE_OTHERS) * abs(a)
