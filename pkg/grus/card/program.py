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
_STAGE = re.compile(r"\s*(load|unload)\s+to\s+(.*)|\s*(hold)\s+for\s+(.*)", re.DOTALL)


@dataclass(frozen=True)
class Stage:
    """One stage: `load` or `unload` to a stress [Pa], or `hold` the stress for a laboratory time [s]."""

    kind: Literal["load", "unload", "hold"]
    stress: Measure | None = None
    duration: Measure | None = None

    def written(self) -> str:
        """As a card would write it, exactly."""
        if self.kind == "hold":
            return f"hold for {self.duration.written()}"
        return f"{self.kind} to {self.stress.written()}"


@dataclass(frozen=True)
class Program:
    """List of stages in words."""

    allowed: str = (
        f"a list of 1 to {MOST_STAGES} stages in quotes: "
        '"load to 100 kPa", "unload to 5 kPa", "hold for 24 h"'
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
        kind, stress, hold, duration = match.groups()
        if hold:
            if not before:
                raise Problem("nothing to hold yet", "a stage that loads comes first")
            return Stage("hold", duration=DURATION.read(duration))
        stage = Stage(kind, stress=STRESS.read(stress))
        last = next((s.stress for s in reversed(before) if s.stress is not None), 0.0)
        if kind == "load" and not stage.stress > last:
            raise Problem(
                f"loads to less than the {last:g} Pa before", "a higher stress, or unload"
            )
        if kind == "unload" and not stage.stress < last:
            raise Problem(f"unloads to more than the {last:g} Pa before", "a lower stress, or load")
        return stage
