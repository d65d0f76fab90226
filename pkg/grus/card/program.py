"""Program of a test: its stages in order."""

import re
from dataclasses import dataclass
from typing import Any, Literal

from grus.card.errors import Problem
from grus.card.interval import POSITIVE
from grus.card.quantity import Measure, Quantity

MOST_STAGES = 1000
STRESS = Quantity({"Pa": "a stress"}, POSITIVE, "100 kPa")
DURATION = Quantity({"s": "a time"}, POSITIVE, "24 h")
WETTING_TIME = Measure(60, "s")
"""Laboratory time that a stage "wet" takes: the cell is flooded in a minute."""
_STAGE = re.compile(
    r"\s*(load|unload)\s+to\s+(.*?)(?:\s+in\s+(.*))?|\s*(hold)\s+for\s+(.*)|\s*(wet)\s*", re.DOTALL
)


@dataclass(frozen=True)
class Stage:
    """One stage: `load` or `unload` to a stress [Pa], `hold` the stress, or `wet` the specimen under it.

    duration: laboratory time [s]; None: the stress is changed at once.
    """

    kind: Literal["load", "unload", "hold", "wet"]
    stress: Measure | None = None
    duration: Measure | None = None

    @property
    def rests(self) -> bool:
        """Whether the stress stays as it is."""
        return self.stress is None

    def written(self) -> str:
        """As a card would write it, exactly."""
        if self.kind == "hold":
            return f"hold for {self.duration.written()}"
        if self.kind == "wet":
            return "wet"
        during = "" if self.duration is None else f" in {self.duration.written()}"
        return f"{self.kind} to {self.stress.written()}{during}"


@dataclass(frozen=True)
class Program:
    """List of stages in words."""

    allowed: str = (
        f"a list of 1 to {MOST_STAGES} stages in quotes: "
        '"load to 100 kPa", "unload to 5 kPa in 1 h", "hold for 24 h", "wet"'
    )

    def read(self, value: Any) -> tuple[Stage, ...]:
        if not isinstance(value, (list, tuple)):
            raise Problem("not a list of stages", self.allowed)
        if not 1 <= len(value) <= MOST_STAGES:
            raise Problem("too few or too many stages", self.allowed)
        stages: list[Stage] = []
        for number, text in enumerate(value, start=1):
            try:
                stages.append(self._stage(text, stages))
            except Problem as problem:
                raise Problem(f"stage {number}: {problem.reason}", problem.allowed) from None
        return tuple(stages)

    def _stage(self, text: Any, before: list[Stage]) -> Stage:
        match = _STAGE.fullmatch(text) if isinstance(text, str) else None
        if match is None:
            raise Problem("not a stage", self.allowed)
        kind, stress, during, hold, duration, wet = match.groups()
        if (hold or wet) and not before:
            raise Problem(f"nothing to {hold or wet} yet", "a stage that loads comes first")
        if hold:
            return Stage("hold", duration=DURATION.read(duration))
        if wet:
            return Stage("wet", duration=WETTING_TIME)
        time = None if during is None else DURATION.read(during)
        stage = Stage(kind, stress=STRESS.read(stress), duration=time)
        last = next((s.stress for s in reversed(before) if s.stress is not None), 0.0)
        if kind == "load" and not stage.stress > last:
            raise Problem(
                f"loads to less than the {last:g} Pa before", "a higher stress, or unload"
            )
        if kind == "unload" and not stage.stress < last:
            raise Problem(f"unloads to more than the {last:g} Pa before", "a lower stress, or load")
        return stage
