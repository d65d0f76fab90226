"""Random oedometer tests with a known program, recorded badly in graded ways.

Every number of a trial follows from its seed and its number.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from grus.record import Record, Segment
from grus.recording.parts import REACHED, SEATING

NOISE = {"quiet": (0.001, 0.003), "noisy": (0.003, 0.01), "rough": (0.01, 0.02)}
"""Standard deviation of a reading of stress, as a share of the stress."""
FULL = 2e-4
"""The same as a share of the highest stress, of an instrument that is read to its full range."""
ROWS = {"short": (20, 60), "usual": (60, 600), "long": (600, 5000)}
RANGE = 300.0
"""Stress over that of the beginning, beyond which nothing is loaded any more."""
FEWEST = 3
"""Readings of each hold, and of each move between two others."""


@dataclass(frozen=True)
class Trial:
    """A record, and what it was made from.

    truth: kind, first and last row of each segment. labels: how it was made and recorded. exact: stress (n,) [Pa]
    without noise. scatter: standard deviation (n,) of the noise [Pa]. program: in the words of a card.
    """

    record: Record
    truth: tuple[tuple[str, int, int], ...]
    labels: dict[str, str]
    exact: np.ndarray
    scatter: np.ndarray
    program: tuple[str, ...]

    @property
    def places(self) -> np.ndarray:
        """Times (n,) [s], or numbers of the readings."""
        return self.record.channels.get("time", np.arange(len(self.record), dtype=float))

    def agrees(self, found: Sequence[Segment]) -> bool:
        """Whether all segments but events have the right kinds and bounds.

        A bound is right within two readings, within a tenth of the shorter segment beside it in readings or in time,
        or where the stress differs by less than two standard deviations from that at the true bound.
        """
        told = [(one.kind, one.first, one.last) for one in found if one.kind != "event"]
        if [kind for kind, _, _ in told] != [kind for kind, _, _ in self.truth]:
            return False
        pairs = zip(self.truth, self.truth[1:], told, told[1:])
        return all(self._bound_agrees(*four) for four in pairs)

    def _bound_agrees(self, before: tuple, after: tuple, told: tuple, told_after: tuple) -> bool:
        true = after[1]
        if (before[0], after[0]) == ("reload", "load"):
            # The highest stress before is known as well as a stress is.
            if abs(np.log(self.exact[told_after[1]] / self.exact[true])) < 0.07:
                return True
        rows = max(2, 0.1 * min(part[2] - part[1] for part in (before, after)))
        x = self.places
        reach = 0.1 * min(x[part[2]] - x[part[1]] for part in (before, after))
        for bound, right in ((told[2], before[2]), (told_after[1], true)):
            between = self.exact[min(bound, right) : max(bound, right) + 1]
            if abs(bound - right) > rows and abs(x[bound] - x[right]) > reach:
                if np.ptp(between) > 2 * self.scatter[right]:
                    return False
        return True


@dataclass(frozen=True)
class Part:
    """Stress from `start` to `end` [Pa] in a `duration` [s]; "seat" and "hold" stay at one stress."""

    kind: str
    start: float
    end: float
    duration: float

    @property
    def rests(self) -> bool:
        return self.kind in ("seat", "hold")


class Draw:
    """Random numbers of one trial."""

    def __init__(self, seed: int, number: int) -> None:
        sequence = np.random.SeedSequence((seed, number))
        self.random = np.random.Generator(np.random.PCG64(sequence)).random

    def between(self, low: float, high: float) -> float:
        return low + (high - low) * self.random()

    def scale(self, low: float, high: float) -> float:
        """Even in the logarithm."""
        return low * (high / low) ** self.random()

    def chance(self, share: float) -> bool:
        return self.random() < share

    def one_of(self, *things: str) -> str:
        return things[int(len(things) * self.random())]

    def gauss(self, count: int) -> np.ndarray:
        """Box and Muller (1958)."""
        radius = np.sqrt(-2 * np.log1p(-self.random(count)))
        return radius * np.cos(2 * np.pi * self.random(count))


def trial(seed: int, number: int, noise: str, rows: str) -> Trial:
    """The trial of that number and grade."""
    draw = Draw(seed, number)
    count = int(draw.scale(*ROWS[rows]))
    shape = draw.one_of("linear", "exponential", "step")
    timing = draw.one_of("even", "jitter", "logarithmic", "by stage")
    overshoot = draw.between(0.01, 0.05) if draw.chance(0.4) else 0.0
    drift = draw.between(-0.01, 0.01) if draw.chance(0.4) else 0.0
    timed = draw.chance(0.7)
    held = shape == "step" or draw.chance(0.8)
    parts = program(draw, shape, most=min(14, count // 4), held=held)
    parts, times, members = readings(draw, parts, timing, count)
    starts = np.cumsum([0.0] + [part.duration for part in parts])
    stress = np.empty(len(times))
    for number, part in enumerate(parts):
        own = members == number
        stress[own] = path(part, shape, overshoot, drift, times[own] - starts[number])
    strain = compression(stress, times, np.array([part.rests for part in parts])[members])
    share = draw.scale(*NOISE[noise])
    scatter = np.hypot(share * stress, FULL * stress.max())
    channels = {
        "time": times,
        "axial_stress": stress + draw.gauss(len(times)) * scatter,
        "axial_strain": strain + draw.gauss(len(times)) * 2e-3 * np.ptp(strain),
    }
    units = {"time": "s", "axial_stress": "Pa", "axial_strain": "1"}
    if not timed:
        del channels["time"], units["time"]
    labels = {
        "noise": noise,
        "rows": rows,
        "shape": shape,
        "timing": timing,
        "time": "timed" if timed else "without time",
        "servo": "overshoots" if overshoot else "exact",
        "drift": "drifts" if drift else "steady",
        "holds": "held" if held else "some turns without a hold",
    }
    truth = segments_of(parts, members, stress)
    return Trial(Record(channels, units), truth, labels, stress, scatter, words(parts))


def program(draw: Draw, shape: str, most: int, held: bool) -> list[Part]:
    """Loads of ratio 1.2 to 4, unloading and reloading; seating and holds or not."""

    def move(kind: str, start: float, end: float) -> Part:
        return Part(kind, start, end, 0.0 if shape == "step" else draw.scale(0.5, 2.0))

    now = highest = draw.scale(2e3, 10e3)
    parts = [Part("seat", now, now, draw.scale(0.5, 5.0))] if draw.chance(0.7) else []
    first = move("load", now, now * draw.between(21.0, 40.0))
    parts.append(first)
    now = highest = first.end
    while True:
        if held or draw.chance(0.5):
            parts.append(Part("hold", now, now, draw.scale(0.2, 10.0)))
        if len(parts) >= most:
            return parts
        if now < 0.9 * highest:
            parts.append(move("reload", now, highest))
            now = highest
            if draw.chance(0.5) and now < RANGE * parts[0].start:
                now = highest * draw.between(1.2, 4.0)
                parts.append(move("load", highest, now))
        elif not parts[-1].rests or draw.chance(0.3) or now > RANGE * parts[0].start:
            parts.append(move("unload", now, now / draw.between(1.25, 10.0)))
            now = parts[-1].end
        else:
            parts.append(move("load", now, now * draw.between(1.2, 4.0)))
            now = parts[-1].end
        highest = max(now, highest)


def words(parts: list[Part]) -> tuple[str, ...]:
    """The program in the words of a card."""
    result = []
    for part, after in zip(parts, [*parts[1:], None]):
        if part.kind == "hold":
            result.append("hold for 1 h")
        elif part.kind == "unload":
            result.append(f"unload to {part.end / 1e3:.6g} kPa")
        elif part.kind == "load" or part.kind == "reload" and (not after or after.kind != "load"):
            result.append(f"load to {part.end / 1e3:.6g} kPa")
    return tuple(result)


def readings(
    draw: Draw, parts: list[Part], timing: str, count: int
) -> tuple[list[Part], np.ndarray, np.ndarray]:
    """The parts, none too short to be read; time of each reading, and the number of its part."""
    interval = sum(part.duration for part in parts) / count
    least = [
        FEWEST if part.rests or _between_moves(parts, n) else 0 for n, part in enumerate(parts)
    ]
    parts = [
        replace(part, duration=max(part.duration, fewest * interval))
        for part, fewest in zip(parts, least)
    ]
    durations = np.array([part.duration for part in parts])
    share = durations / durations.sum()
    if timing in ("logarithmic", "by stage"):
        share = np.array([draw.between(0.5, 1.5) * (part.duration > 0) for part in parts])
        share /= share.sum()
    columns = []
    for part, fewest, own in zip(parts, least, share):
        size = max(int(round(count * own)), fewest) if part.duration else 0
        place = (np.arange(size) + 0.5) / max(size, 1)
        if timing == "jitter" and size:
            place += 0.9 * (draw.random(size) - 0.5) / size
        elif timing == "logarithmic" and part.rests:
            place = np.geomspace(1e-3, 0.99, size)
        columns.append(part.duration * place)
    starts = np.cumsum(durations) - durations
    times = np.concatenate([start + column for start, column in zip(starts, columns)])
    return parts, times, np.repeat(np.arange(len(parts)), [len(column) for column in columns])


def _between_moves(parts: list[Part], number: int) -> bool:
    beside = parts[max(number - 1, 0) : number] + parts[number + 1 : number + 2]
    return not parts[number].rests and any(not part.rests for part in beside)


def path(part: Part, shape: str, overshoot: float, drift: float, t: np.ndarray) -> np.ndarray:
    """Stress (n,) at times t (n,) since the start of a part."""
    done = t / part.duration if part.duration else t
    if part.kind == "seat":
        return np.full(len(t), part.start)
    if part.kind == "hold":
        return part.start * (1 + overshoot * np.exp(-done / 0.04) + drift * done)
    if shape == "exponential":
        return part.start * (part.end / part.start) ** done
    return part.start + (part.end - part.start) * done


def compression(stress: np.ndarray, time: np.ndarray, rests: np.ndarray) -> np.ndarray:
    """Strain (n,): a line in the logarithm of stress, stiffer below the highest one, and creep."""
    highest = np.maximum.accumulate(stress)
    creep = np.cumsum(np.where(rests, np.diff(time, prepend=time[0]), 0.0)) / time[-1]
    return 0.002 * np.log(stress) + 0.01 * np.log(highest / highest[0]) + 0.002 * creep


def segments_of(
    parts: list[Part], members: np.ndarray, stress: np.ndarray
) -> tuple[tuple[str, int, int], ...]:
    """Kind and first and last row of each segment; moves reach from and to the readings at rest.

    Reloading ends at the highest stress that was read, which may be less than the highest there was.
    """
    result: list[tuple[str, int, int]] = []
    here = number = 0
    while number < len(parts):
        if parts[number].rests:
            own = np.flatnonzero(members == number)
            result.append((parts[number].kind, int(own[0]), int(own[-1])))
        else:
            last = number + (
                parts[number].kind == "reload"
                and parts[number + 1 : number + 2] != []
                and parts[number + 1].kind == "load"
            )
            after = parts[last + 1 : last + 2]
            if after and after[0].rests:
                end = int(np.flatnonzero(members == last + 1)[0])
            else:
                end = int(np.flatnonzero(members <= last)[-1])
            if end > here:
                result += _moved(parts[number].kind, here, end, stress, parts[last].end)
            number = last
        here = result[-1][2] if result else 0
        number += 1
    if result[0][0] == "hold" and parts[0].end <= SEATING * max(part.end for part in parts):
        result[0] = ("seat", *result[0][1:])
    return tuple(result)


def _moved(
    kind: str, first: int, last: int, stress: np.ndarray, end: float
) -> list[tuple[str, int, int]]:
    highest = stress[: first + 1].max()
    if kind != "reload" or end <= REACHED * highest:
        return [(kind, first, last)]
    beyond = np.flatnonzero(stress[first : last + 1] > highest)
    if not len(beyond):
        return [(kind, first, last)]
    middle = first + int(beyond[0]) - 1
    return [("reload", first, middle)] * (middle > first) + [("load", middle, last)]
