"""What a laboratory would have written down of a test."""

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from grus.oedometer.program import Planned, has_clock, program
from grus.oedometer.result import SEAT, OedometerResult
from grus.oedometer.test import OedometerTest
from grus.record import Record, Segment

UNITS = {
    "time": "s",
    "axial_stress": "Pa",
    "axial_strain": "1",
    "base_stress": "Pa",
    "lateral_stress": "Pa",
    "ae_events": "1",
}
FIRST_READING, READINGS_A_DECADE = 1.0, 10
"""Readings of a hold: the first after this time [s], and so many in each decade of it."""


class Reading(NamedTuple):
    """A row: laboratory time [s], top stress [Pa], height [m], base and side stress [Pa], broken bonds so far."""

    time: float
    top: float
    height: float
    base: float
    side: float
    breaks: int


def laboratory(test: OedometerResult | OedometerTest) -> Record:
    """Record of a test that has run, or of one in the current scene as far as it has come.

    Channels: time [s] on the laboratory clock, axial_stress [Pa] on the top platen, axial_strain [-] from the height at
    the end of the seating, base_stress and lateral_stress [Pa], ae_events: broken bonds so far. A load that takes time
    has a row each time its stresses are beyond all before, one that is put on at once its end only; a hold has rows at
    logarithmic times and at delayed failures. A program without any time gives a record without `time`, and all rows
    of its loads. Each stage is a segment, neighbours share a row; `meta` has the height [m].
    """
    plan = program(test.card)
    notes = _Notes(test, plan)
    for number in range(int(test.record["stage"].max(initial=0)) + 1):
        notes.add(number)
    return notes.record()


@dataclass
class _Notes:
    """Readings and segments so far."""

    test: OedometerResult | OedometerTest
    plan: list[Planned]
    rows: list[Reading] = field(default_factory=list)
    segments: list[Segment] = field(default_factory=list)

    def add(self, number: int) -> None:
        """Adds a stage."""
        stage = self.plan[number]
        begin = max(len(self.rows) - 1, 0)
        own = np.flatnonzero(self.test.record["stage"] == number)
        if stage.kind == "hold":
            held = self._held(number, int(own[-1]))
            # What breaks before the clock goes on belongs to the stage before, which shares this row.
            self.rows[-1] = held[0]
            self.rows += held[1:]
        elif stage.kind in ("load", "unload"):
            self.rows += self._moved(stage, own)
        else:
            self.rows.append(self._row(int(own[-1]), stage.ends))
        self._cut(number, begin)

    def _row(self, row: int, time: float) -> Reading:
        r = self.test.record
        breaks = int(r["tension_breaks"][row] + r["shear_breaks"][row])
        columns = ("top_stress", "height", "bottom_stress", "side_stress")
        return Reading(time, *(float(r[name][row]) for name in columns), breaks)

    def _moved(self, stage: Planned, own: np.ndarray) -> list[Reading]:
        """Of a load: where its stress is beyond all before, at the time when it is due, and its end."""
        sense = 1.0 if stage.stress > stage.start else -1.0
        top, base = (self.test.record[name][own] for name in ("top_stress", "bottom_stress"))
        stress = top if self.test.card.oedometer.platens == "top" else (top + base) / 2
        ahead = sense * stress < sense * stage.stress
        for values in (stress, top):
            before = sense * np.concatenate([[stage.start], values[:-1]])
            ahead &= sense * values > np.maximum.accumulate(before)
        if has_clock(self.plan) and not stage.timed:
            ahead[:] = False
        ahead[-1] = False
        share = (stress - stage.start) / (stage.stress - stage.start)
        times = stage.begins + share * (stage.ends - stage.begins)
        way = [self._row(int(own[i]), float(times[i])) for i in np.flatnonzero(ahead)]
        return [*way, self._row(int(own[-1]), stage.ends)]

    def _held(self, number: int, last: int) -> list[Reading]:
        """Of a hold: what its clock has recorded, or the same state at all times when bonds do not age."""
        stage, rests = self.plan[number], self.test.rests
        if not len(rests):
            steps = np.arange(1 + np.ceil(READINGS_A_DECADE * np.log10(stage.ends - stage.begins)))
            passed = FIRST_READING * 10 ** (steps / READINGS_A_DECADE)
            passed = passed[passed < stage.ends - stage.begins]
            times = [stage.begins, *(stage.begins + passed), stage.ends]
            return [self._row(last, float(time)) for time in times]
        own = np.flatnonzero(rests["stage"] == number)
        clock = rests["clock"][own]
        # Of several rests at one time, an avalanche, the last.
        own = own[np.append(np.diff(clock) > 0, True)]
        columns = ("clock", "top_stress", "height", "bottom_stress", "side_stress")
        return [
            Reading(*(float(rests[name][i]) for name in columns), int(rests["breaks"][i]))
            for i in own
        ]

    def _cut(self, number: int, begin: int) -> None:
        """The stage that ends with the last row as a segment; loading beyond the highest stress before as two."""
        stage, end = self.plan[number], len(self.rows) - 1
        kind = {SEAT: "seat", "wet": "hold"}.get(stage.kind, stage.kind)
        highest = max(one.stress for one in self.plan[:number]) if number else stage.stress
        if kind == "load" and stage.start < highest:
            stress = np.array([row.top for row in self.rows[begin:end]])
            below = begin + int((stress <= highest).sum()) - 1 if stage.stress > highest else end
            if below > begin:
                self._segment(
                    "reload", number, begin, below, stage.start, min(highest, stage.stress)
                )
                begin, start = below, highest
            if below == end:
                return
        start = highest if kind == "load" and self.segments[-1].stage == number else stage.start
        self._segment(kind, number, begin, end, start, stage.stress)
        if stage.kind == "wet":
            self._segment("event", number, begin, end, start, stage.stress)

    def _segment(
        self, kind: str, number: int, first: int, last: int, start: float, end: float
    ) -> None:
        timed = has_clock(self.plan)
        t0, t1 = (self.rows[i].time if timed else None for i in (first, last))
        self.segments.append(Segment(kind, number, first, last, t0, t1, start, end))

    def record(self) -> Record:
        columns = dict(zip(Reading._fields, map(np.array, zip(*self.rows))))
        height = float(self.rows[0].height)
        channels = {
            "time": columns["time"],
            "axial_stress": columns["top"],
            "axial_strain": 1 - columns["height"] / height,
            "base_stress": columns["base"],
            "lateral_stress": columns["side"],
            "ae_events": columns["breaks"],
        }
        if not has_clock(self.plan):
            del channels["time"]
        card = self.test.card
        meta = {"model": card.name, "seed": card.seed, "height": height}
        units = {name: UNITS[name] for name in channels}
        return Record(channels, units, meta, tuple(self.segments))
