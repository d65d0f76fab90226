"""The curves that stand behind the numbers a diagnosis compares: strain over stress and time, stage by stage."""

from dataclasses import dataclass

import numpy as np

from grus.diagnosis.cells import Cells
from grus.diagnosis.diagnosis import Diagnosis


@dataclass(frozen=True)
class StageCurve:
    """Strain [-] of the recording and of the models at the knots (m+1,) of a stage.

    stage: number in the recording. kind: of its segment. rows: readings of the recording. time [s] (number of the reading without
    times) and stress [Pa]: of the knots. recorded: the recording, freed of noise. before: the calibrated base as simulated, in the
    middle of its specimens (s, m+1). after: the same with the mechanisms, delayed failure smoothed; None
    where none was put back.
    foreseen: of a stage left out of the fit, what base, and base with mechanisms, expect of it after
    the other stages, from the recorded strain at its beginning on; None elsewhere.
    """

    stage: int
    kind: str
    rows: np.ndarray
    time: np.ndarray
    stress: np.ndarray
    recorded: np.ndarray
    before: np.ndarray
    specimens: np.ndarray
    after: np.ndarray | None
    foreseen: tuple[np.ndarray, np.ndarray] | None


def curves(diagnosis: Diagnosis) -> list[StageCurve]:
    """Of all stages that are compared, in their order.

    Changes of strain add up along the test; between the stages, where nothing is compared, the models do as the recording.
    """
    compared, fit = diagnosis.calibration.compared, diagnosis.improvement
    base, scale = diagnosis.library.scatter.mean, diagnosis.calibration.stiffness
    after = base if fit is None else base + fit.change
    specimens = [compared.of(record) for record in diagnosis.library.plain.values()]
    changes = np.array([base, after, *specimens]) / scale
    found: list[StageCurve] = []
    levels, end = np.zeros(len(changes)), 0.0
    for part in compared.parts:
        own = np.flatnonzero(compared.where(stage=part.stage, channel="strain"))
        recorded = _recorded(diagnosis, part)
        levels = levels + recorded[0] - end
        models = levels[:, None] + _risen(changes[:, own])
        levels, end = models[:, -1], recorded[-1]
        foreseen = None
        if fit is not None and part.stage in fit.left_out:
            foreseen = tuple(
                recorded[0] + _risen((base + one.foreseen)[own] / scale)
                for one in (fit.before, fit.after)
            )
        segment = diagnosis.protocol.segments[part.stage]
        time, stress = _places(diagnosis, part)
        found.append(
            StageCurve(
                segment.stage,
                segment.kind,
                part.rows,
                time,
                stress,
                recorded,
                models[0],
                models[2:],
                None if fit is None else models[1],
                foreseen,
            )
        )
    return found


def _risen(changes: np.ndarray) -> np.ndarray:
    """What changes (..., m) over cells add up to at the knots (..., m+1), from 0 on."""
    return np.concatenate([np.zeros_like(changes[..., :1]), np.cumsum(changes, axis=-1)], axis=-1)


def _recorded(diagnosis: Diagnosis, part: Cells) -> np.ndarray:
    """Strain (m+1,) of the recording at the knots, freed of noise."""
    strain = diagnosis.recording["axial_strain"][part.rows]
    risen = _risen(part.changes @ strain)
    return risen + np.mean(strain - _at(part, risen, part.at))


def _places(diagnosis: Diagnosis, part: Cells) -> tuple[np.ndarray, np.ndarray]:
    """Time and stress (m+1,) of the knots."""
    record, segment = diagnosis.recording, diagnosis.protocol.segments[part.stage]
    clock = record["time"] if diagnosis.protocol.timed else np.arange(float(len(record)))
    first, last = clock[segment.first], clock[segment.last]
    if part.kind == "hold":
        share = part.knots
        stress = segment.stress_from + share * (segment.stress_to - segment.stress_from)
        return first + share * (last - first), stress
    # Noise lets the stress go back now and then.
    passed = np.maximum.accumulate(part.at if part.knots[-1] > part.knots[0] else -part.at)
    knots = part.knots if part.knots[-1] > part.knots[0] else -part.knots
    return np.interp(knots, passed, clock[part.rows]), part.knots


def _at(part: Cells, values: np.ndarray, places: np.ndarray) -> np.ndarray:
    order = np.argsort(part.knots)
    return np.interp(places, part.knots[order], values[order])
