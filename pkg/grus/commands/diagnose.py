"""`grus diagnose`: what physics a model leaves out, by a recording of a laboratory test."""

from pathlib import Path
from typing import Optional

import typer
from rich.console import Console

from grus.card import Card
from grus.card.toml_file import read as read_toml
from grus.commands.diagnosis_progress import DiagnosisProgress
from grus.commands.staged_progress import staged_progress
from grus.errors import GrusError


def diagnose(
    recording: str = typer.Argument(..., help="Recording of a test, CSV or xlsx."),
    model: str = typer.Option(..., help="Model card, a file in TOML."),
    out: str = typer.Option(..., help="Folder for the results."),
    jobs: Optional[int] = typer.Option(
        None, min=1, help="Runs at a time.", show_default="one a core"
    ),
    budget: Optional[float] = typer.Option(
        None, min=0, help="Minutes after which no run is begun.", show_default="none"
    ),
    seed: int = typer.Option(1, min=1, max=2_000_000, help="Seed of the specimens."),
    program: Optional[str] = typer.Option(
        None,
        help="Stages of the test: a file in TOML with a list `stages`, by itself or in [oedometer] as in a card.",
        show_default="found in the recording",
    ),
    height: Optional[str] = typer.Option(
        None,
        help='Height of the specimen, "20 mm"; needed for settlements.',
        show_default="from the recording",
    ),
    store: Optional[str] = typer.Option(
        None,
        help="Folder of the runs, which diagnoses of the same test share.",
        show_default="runs, in the folder of the results",
    ),
) -> None:
    """Say what physics a model leaves out of a laboratory test, and show what improves when it is put back."""
    # Not at the top: statistics and matplotlib would slow every other command.
    from grus.diagnosis import diagnose as run
    from grus.diagnosis.report import summary, write_report
    from grus.recording import read

    card = Card.from_file(model)
    record = read(recording, height=height)
    stages = None if program is None else _stages(program)
    runs = store or str(Path(out) / "runs")
    with staged_progress() as show:
        say = DiagnosisProgress(show)
        try:
            found = run(record, card, runs, seed, jobs, budget and 60 * budget, say, stages)
        except KeyboardInterrupt:
            raise KeyboardInterrupt(
                f"interrupted; finished runs are kept in {runs}, the same command goes on from there"
            ) from None
    files = write_report(found, out)["files"]
    Console().print(summary(found))
    print(f"\nresults in {out}: {', '.join(files)}")


def _stages(path: str) -> list[str]:
    table = read_toml(path)
    stages = table.get("oedometer", table).get("stages")
    if not isinstance(stages, list) or not all(isinstance(one, str) for one in stages):
        raise GrusError(
            f'{path}: stages is missing or no list of texts; allowed: stages = ["load to 100 kPa"]'
        )
    return stages
