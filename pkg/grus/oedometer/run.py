"""Running an oedometer test, with checkpoints."""

from pathlib import Path

from yade import O

from grus.card import Card
from grus.errors import GrusError
from grus.oedometer.clock import rests, set_clock
from grus.oedometer.files import TestFiles
from grus.oedometer.program import Planned, program
from grus.oedometer.result import SEAT, OedometerResult, StageEnd
from grus.oedometer.stage import Progress, StageRun
from grus.oedometer.test import OedometerTest, at_end, element_ids, ledger, record, servo
from grus.preparation import PreparedSpecimen, prepare
from grus.scene import CALMING, contacts, set_damping, snapshot


SEATING = 0.05
"""Tolerance of the seating stress: under so little, loose grains that wander keep the stress from standing still."""


def oedometer(
    card: Card,
    folder: str | Path,
    progress: Progress | None = None,
    specimens: str | Path | None = None,
    checkpoint: float = 120.0,
    restart: bool = False,
    specimen_card: Card | None = None,
) -> OedometerResult:
    """Prepares the specimen of `card` and runs its stages, in the current YADE scene, which is emptied first.

    The prepared specimen is saved in the folder `specimens` (default: `folder`) and taken from there by every test whose
    card has the same. The end of each stage and, every `checkpoint` seconds, the whole scene are saved in `folder`. A call
    that finds them there goes on from the last: with the same result, bit by bit on one thread. With `restart` they are
    discarded first; the prepared specimen is kept. With `specimen_card` the specimen is the one of that card: two tests
    that differ in their contacts and bonds alone can have the same packing, grain by grain.
    Raises GrusError when the card has no oedometer test, when `folder` holds another test, when the specimen cannot be
    prepared, when platens meet or forces are not numbers, or when a stage does not end within `oedometer.max_steps`; what
    has been computed until then stays. Ctrl-C saves the scene and is passed on.
    """
    for table in ("specimen", "oedometer"):
        if getattr(card, table) is None:
            raise GrusError(f"{card.source}: {table} is missing; allowed: a table [{table}]")
    tell = progress or (lambda share, line: None)
    files = TestFiles(card, Path(folder))
    if restart:
        files.discard()
    try:
        prepared = prepare(specimen_card or card, specimens or folder, lambda line: tell(0.0, line))
    except BaseException:
        files.release()
        raise
    stages = program(card)
    if not files.load_scene():
        OedometerTest(card, prepared)
    try:
        for number, stage in enumerate(stages):
            if _is_over(number, files):
                continue
            if servo().stage < number:
                begin(card, stage)
            StageRun(card, stages, files, checkpoint).finish(tell)
            files.save_stage(_stage_end(number, stage, prepared))
            files.save_scene()
    except KeyboardInterrupt:
        files.save_scene()
        now = max(servo().stage, 0)
        raise KeyboardInterrupt(
            f"interrupted in stage {now}, {stages[now].name}, after {O.iter} steps; saved in {files.folder}, "
            "start it again to go on from there"
        ) from None
    bonds = len(prepared.specimen.bonds()) if card.bond.kind != "none" else 0
    ends = tuple(files.load_stage(number) for number in range(len(stages)))
    return OedometerResult(card, prepared, bonds, record(), ends, rests())


def begin(card: Card, stage: Planned) -> None:
    """Begins the next stage in the current scene; the clock of a hold starts once the specimen is quiet."""
    servo().tolerance = SEATING if stage.kind == SEAT else card.oedometer.tolerance
    set_damping(CALMING if stage.kind == SEAT else card.oedometer.damping)
    servo().begin(stage.stress, settled=stage.kind == "hold")
    set_clock(stage)


def _is_over(number: int, files: TestFiles) -> bool:
    """Whether the scene is past a stage, or at its end and the stage is saved: a run may be killed in between."""
    s = servo()
    return s.stage > number or (s.stage == number and at_end() and files.has_stage(number))


def _stage_end(number: int, stage: Planned, prepared: PreparedSpecimen) -> StageEnd:
    s, broken, ids = servo(), ledger(), element_ids()
    return StageEnd(
        number=number,
        kind=stage.kind,
        target=stage.stress,
        height=s.height,
        void_ratio=s.voidRatio,
        axial_stress=(s.topStress + s.bottomStress) / 2,
        side_stress=s.sideStress,
        tension_breaks=broken.tensionBreaks,
        shear_breaks=broken.shearBreaks,
        steps=O.iter,
        state=snapshot(prepared.specimen, ids),
        contacts=contacts(ids),
    )
