"""`grus prove`: judge trials in which an effect is concealed, and score the verdicts."""

from pathlib import Path
from typing import Optional

import typer

from grus.card import Card
from grus.commands.staged_progress import staged_progress

ROOT = Path(__file__).resolve().parents[3]
CONCEALED = ROOT / "validation" / "concealed" / "trials"


def prove(
    trials: str = typer.Option(
        "quick", help="all, quick (four that share their runs), or development."
    ),
    model: str = typer.Option(
        str(ROOT / "models" / "quick.toml"),
        help="Model card, a file in TOML.",
        show_default="models/quick.toml",
    ),
    out: str = typer.Option(..., help="Folder for verdicts, runs and the score."),
    folder: str = typer.Option(
        str(CONCEALED), help="Folder of the trials.", show_default="validation/concealed/trials"
    ),
    jobs: Optional[int] = typer.Option(None, help="Runs at a time.", show_default="one a core"),
    budget: Optional[float] = typer.Option(
        None, help="Minutes for each trial.", show_default="no limit"
    ),
) -> None:
    """Diagnose trials in which an effect is concealed, open their answers, and score the verdicts."""
    # Not at the top: statistics would slow every other command.
    from grus.proof import prove as run
    from grus.proof import summary, write_report

    limit = budget and 60 * budget
    with staged_progress() as show:
        found = run(folder, trials, Card.from_file(model), out, jobs, limit, show)
    files = write_report(found, out)
    print(summary(found))
    print(f"\nresults in {out}: {', '.join(files)}")
