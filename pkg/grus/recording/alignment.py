"""Cutting a record at the stages of the program that was run."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from grus.card.errors import Problem
from grus.card.program import Program, Stage
from grus.errors import GrusError
from grus.recording.parts import Found, Part, find, named
from grus.recording.path import CLEAR, StressPath
from grus.recording.rests import STEADY

LOOSE = 0.03
"""Standard deviation of the stress that was reached, as a share of the one in the program."""
FARTHEST = 0.1
"""Largest distance of both, the same share."""
IN_MOTION, OFF_MOTION = 2.0, 6.0
"""Chi-square of a reading of a move, and of one that rests or goes the other way."""


@dataclass(frozen=True)
class _Step:
    """A stage as it shows in the stress: from `start` to `end` [Pa], or at `end`; holds after each other are one step."""

    start: float
    end: float
    stages: tuple[int, ...]
    rests: bool = False


def read_program(program: Sequence[str | Stage]) -> tuple[Stage, ...]:
    """Stages from their words ("load to 100 kPa"); GrusError for what is none."""
    words = [stage.written() if isinstance(stage, Stage) else stage for stage in program]
    try:
        return Program().read(words)
    except Problem as problem:
        raise GrusError(f"program: {problem.reason}; allowed: {problem.allowed}") from None


def aligned_parts(
    stress: np.ndarray, x: np.ndarray, path: StressPath, program: tuple[Stage, ...]
) -> list[Part]:
    """Parts by the stages of the program, which are numbered from 1; what comes before them is the seating.

    stress (n,) [Pa] at places x (n,), not falling. Raises GrusError when the record does not follow the program.
    """
    told = find(stress, x, path)
    steps = _steps(told, program)
    if not _same(told, steps, path):
        told = _cut(stress, path, steps, told)
        _check(steps, told, path, program)
    found: list[Found] = []
    stages: list[int] = []
    for step, (first, last, start, end) in zip(steps, told):
        for stage, (a, b) in zip(step.stages, _shared(first, last, x, step, program)):
            found.append((a, b, start, end))
            stages.append(stage)
    return named(found, path, stages)


def _steps(told: list[Found], program: tuple[Stage, ...]) -> list[_Step]:
    """Steps of the program, with the seating before it, and without a first load that was on before the recording."""
    _, _, start, end = told[0]
    target = float(program[0].stress)
    steps: list[_Step] = []
    loaded = start == end and abs(start - target) <= FARTHEST * target
    if start == end and start < target and not loaded:
        steps.append(_Step(start, start, (0,), rests=True))
    for number, stage in enumerate(program, start=1):
        if number == 1 and loaded:
            continue
        if stage.rests and steps and steps[-1].rests:
            steps[-1] = _Step(start, start, (*steps[-1].stages, number), rests=True)
            continue
        end = start if stage.rests else float(stage.stress)
        steps.append(_Step(start, end, (number,), rests=stage.rests))
        start = end
    return steps


def _same(told: list[Found], steps: list[_Step], path: StressPath) -> bool:
    """Whether the stages told from the stress alone are those of the program."""
    if len(told) != len(steps):
        return False
    for (_, last, start, end), step in zip(told, steps):
        if np.sign(end - start) != np.sign(step.end - step.start):
            return False
        if abs(end - step.end) > _room(step, last, path):
            return False
    return True


def _room(step: _Step, last: int, path: StressPath) -> float:
    """How far [Pa] the stress at the last row of a step may be from that of the program."""
    room = max(FARTHEST * step.end, CLEAR * float(path.noise[last]))
    if step.rests:
        return room
    # A turn may lie between two readings.
    beside = path.at(np.clip([last - 1, last, last + 1], 0, len(path.noise) - 1))
    return max(room, float(np.abs(np.diff(beside)).max()))


def _cut(
    stress: np.ndarray, path: StressPath, steps: list[_Step], told: list[Found]
) -> list[Found]:
    """Rests and moves at the stages of the program, at the stresses that were reached."""
    sense = np.zeros(len(stress))
    for first, last, start, end in told:
        sense[first + (start != end) : last + (start == end)] = np.sign(end - start)
    at_once = np.array([not step.rests for step in steps])
    members = _assign(_costs(path, steps, sense, LOOSE), at_once)
    levels = [
        float(np.median(stress[members == number]) if (members == number).any() else step.end)
        for number, step in enumerate(steps)
    ]
    reached = []
    for number, step in enumerate(steps):
        end = levels[number] if step.rests else step.end
        if not step.rests and number + 1 < len(steps) and steps[number + 1].rests:
            end = levels[number + 1]
        start = end if step.rests else (reached[-1].end if reached else step.start)
        reached.append(_Step(start, end, step.stages, step.rests))
    members = _assign(_costs(path, reached, sense, STEADY), at_once)
    result: list[Found] = []
    here = 0
    for number, step in enumerate(reached):
        own = np.flatnonzero(members == number)
        following = reached[number + 1] if number + 1 < len(reached) else None
        if step.rests:
            here, last, start, end = int(own[0]), int(own[-1]), step.end, step.end
        else:
            start = result[-1][3] if result else step.start
            if following and following.rests:
                last, end = int(np.flatnonzero(members == number + 1)[0]), step.end
            else:
                last = _turn(
                    path, here, own, np.flatnonzero(members == number + 1), step, following
                )
                end = float(path.at(last))
        result.append((here, last, start, end))
        here = last
    return result


def _turn(
    path: StressPath,
    here: int,
    own: np.ndarray,
    after: np.ndarray,
    step: _Step,
    following: _Step | None,
) -> int:
    """Row at which a move ends that no rest follows: where the stress turns, if the next move goes back."""
    last = int(own[-1]) if len(own) else here
    way = np.sign(step.end - step.start)
    if following is None or np.sign(following.end - following.start) == way or not len(after):
        return last
    rows = np.arange(here, int(after[-1]) + 1)
    return int(rows[np.argmax(way * path.at(rows))])


def _costs(path: StressPath, steps: list[_Step], sense: np.ndarray, loose: float) -> np.ndarray:
    """Chi-square (n, k) of each reading as one of each step.

    sense: 1 where the stress is told to rise, -1 where it falls (n,). loose: standard deviation of the stress of a step
    as a share of it.
    """
    value = path.at(np.arange(len(path.noise)))
    costs = np.empty((len(value), len(steps)))
    for number, step in enumerate(steps):
        low, high = sorted((step.start, step.end))
        outside = np.maximum(np.maximum(low - value, value - high), 0.0)
        scatter = np.hypot(path.noise, loose * np.where(value < low, low, high))
        costs[:, number] = (outside / scatter) ** 2
        if not step.rests:
            along = sense == np.sign(step.end - step.start)
            costs[:, number] += np.where(along, IN_MOTION, OFF_MOTION)
    return costs


def _assign(costs: np.ndarray, skipped: np.ndarray) -> np.ndarray:
    """Step (n,) of each reading, in order, at the least sum of costs (n, k).

    Every step has a reading but those that may be skipped (k,): a load that was put on at once has none.
    """
    count, steps = costs.shape
    come_from = np.zeros((count, steps), dtype=np.int8)
    best = np.full(steps, np.inf)
    best[0] = costs[0, 0]
    if steps > 1 and skipped[0]:
        best[1] = costs[0, 1]
    for row in range(1, count):
        options = np.full((3, steps), np.inf)
        options[0] = best
        options[1, 1:] = best[:-1]
        options[2, 2:] = np.where(skipped[1:-1], best[:-2], np.inf)
        come_from[row] = options.argmin(axis=0)
        best = options.min(axis=0) + costs[row]
    if not np.isfinite(best[-1]):
        raise GrusError(
            f"program: {steps} stages, but {count} readings; allowed: a reading of each stage at least"
        )
    members = np.empty(count, dtype=int)
    members[-1] = steps - 1
    for row in range(count - 1, 0, -1):
        members[row - 1] = members[row] - come_from[row, members[row]]
    return members


def _check(
    steps: list[_Step], told: list[Found], path: StressPath, program: tuple[Stage, ...]
) -> None:
    for step, (first, last, _, end) in zip(steps, told):
        stage = step.stages[-1]
        if (
            not stage
            or abs(end - step.end) <= _room(step, last, path)
            and (last > first or step.rests)
        ):
            continue
        words = program[stage - 1].written()
        raise GrusError(
            f'program stage {stage} "{words}": the recording has {end / 1e3:.4g} kPa there; '
            f"allowed: a program that the recording follows within {FARTHEST:.0%}"
        )


def _shared(
    first: int, last: int, x: np.ndarray, step: _Step, program: tuple[Stage, ...]
) -> list[tuple[int, int]]:
    """First and last row of each stage of a step: several holds after each other have their shares of the time."""
    if len(step.stages) == 1:
        return [(first, last)]
    held = np.array([program[stage - 1].duration or 0.0 for stage in step.stages], dtype=float)
    places = x[first] + np.cumsum(held) / held.sum() * (x[last] - x[first])
    rows = [first + int(np.searchsorted(x[first : last + 1], place)) for place in places[:-1]]
    return list(zip([first, *rows], [*rows, last]))
