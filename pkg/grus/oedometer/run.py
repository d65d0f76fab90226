"""Running an oedometer test, with checkpoints."""

import time
from collections.abc import Callable
from pathlib import Path

import h5py
from yade import O

from grus.card import Card
from grus.errors import GrusError
from grus.files import discard_partial, replacing
from grus.oedometer.result import SEAT, OedometerResult, StageEnd
from grus.oedometer.test import OedometerTest, element_ids, ledger, record, servo
from grus.ownership import claim
from grus.preparation import PreparedSpecimen, prepare
from grus.scene import Snapshot, snapshot

Progress = Callable[[str], None]
SLICE = 2000  # steps between two looks at the clock
NUMBERS = [name for name in StageEnd.__annotations__ if name != "state"]


def program(card: Card) -> list[tuple[str, float]]:
    """Kind and axial stress [Pa] of each stage; first the seating, and a hold stays at the stress before."""
    stages = [(SEAT, float(card.preparation.seating_stress))]
    for stage in card.oedometer.stages:
        stress = stages[-1][1] if stage.stress is None else float(stage.stress)
        stages.append((stage.kind, stress))
    return stages


def oedometer(
    card: Card, folder: str | Path, progress: Progress | None = None, checkpoint: float = 180.0
) -> OedometerResult:
    """Prepares the specimen of `card` and runs its stages, in the current YADE scene, which is emptied first.

    The specimen, the end of each stage and every `checkpoint` seconds the whole scene are saved in `folder`. A call that
    finds them there goes on from the last: with the same result, bit by bit on one thread. `progress` is called with a
    line now and then. Raises GrusError when the card has no oedometer test or `folder` holds another test.
    """
    if card.oedometer is None or card.specimen is None:
        missing = "oedometer" if card.oedometer is None else "specimen"
        raise GrusError(f"{card.source}: {missing} is missing; allowed: a table [{missing}]")
    tell = progress or (lambda line: None)
    files = _Files(card, Path(folder))
    prepared = prepare(card, folder, progress)
    bonds = len(prepared.specimen.bonds())
    if files.scene.exists():
        O.reset()
        O.load(str(files.scene))
        tell(f"going on at step {O.iter}")
    else:
        OedometerTest(card, prepared)
    for number, (kind, stress) in enumerate(program(card)):
        if files.has_stage(number):
            continue
        if servo().stage < number:
            servo().begin(stress)
        _finish_stage(f"{kind} to {stress / 1e3:g} kPa", files, tell, checkpoint)
        files.save_stage(_stage_end(number, kind, stress, prepared))
        files.save_scene()
    stages = tuple(files.load_stage(number) for number in range(len(program(card))))
    return OedometerResult(card, prepared, bonds, record(), stages)


def _finish_stage(title: str, files: "_Files", tell: Progress, checkpoint: float) -> None:
    saved = time.monotonic()
    while not servo().done:
        O.run(SLICE, True)
        s = servo()
        tell(
            f"{title}: {s.topStress / 1e3:.4g} kPa, strain {s.strain:.3%}, {ledger().breaks} bonds broken, "
            f"step {O.iter}"
        )
        if time.monotonic() - saved > checkpoint:
            files.save_scene()
            saved = time.monotonic()


def _stage_end(number: int, kind: str, stress: float, prepared: PreparedSpecimen) -> StageEnd:
    s, broken = servo(), ledger()
    return StageEnd(
        number=number,
        kind=kind,
        target=stress,
        height=s.height,
        void_ratio=s.voidRatio,
        axial_stress=(s.topStress + s.bottomStress) / 2,
        side_stress=s.sideStress,
        tension_breaks=broken.tensionBreaks,
        shear_breaks=broken.shearBreaks,
        steps=O.iter,
        state=snapshot(prepared.specimen, element_ids()),
    )


class _Files:
    """Checkpoint and stages of one test in a folder."""

    def __init__(self, card: Card, folder: Path) -> None:
        self.folder.mkdir(exist_ok=True)
        discard_partial(self.folder)

    def save_scene(self) -> None:
        with replacing(self.scene) as partial:
            O.save(str(partial), quiet=True)

    def path(self, number: int) -> Path:
        return self.folder / f"stage-{number:03d}.h5"

    def has_stage(self, number: int) -> bool:
        # The scene is saved after the stage: without it the stage has to be run again.
        return self.path(number).exists() and self.scene.exists() and servo().stage >= number

    def save_stage(self, end: StageEnd) -> None:
        with replacing(self.path(end.number)) as partial, h5py.File(partial, "w") as file:
            for name in NUMBERS:
                file.attrs[name] = getattr(end, name)
            for name, values in vars(end.state).items():
                file.create_dataset(name, data=values)

    def load_stage(self, number: int) -> StageEnd:
        with h5py.File(self.path(number), "r") as file:
            numbers = {name: file.attrs[name] for name in NUMBERS}
            return StageEnd(**numbers, state=Snapshot(**{name: file[name][()] for name in file}))
