"""`grus calibrate`: fit parameters of a card to laboratory results."""

from pathlib import Path
from typing import Optional

import typer
from rich.console import Console

from grus.card import Card
from grus.commands.progress import progress_bar


def calibrate(
    model: str = typer.Argument(..., metavar="CARD", help="Model card, a file in TOML."),
    targets: str = typer.Argument(
        ..., help="Parameters with bounds, and targets with tolerances: a file in TOML."
    ),
    out: str = typer.Option(..., help="Folder for the results; a run that was cut off goes on."),
    jobs: Optional[int] = typer.Option(
        None, min=1, help="Runs at a time on this machine.", show_default="one a core"
    ),
    trials: int = typer.Option(40, min=1, help="Sets of parameters that are tried."),
    scheduler: Optional[str] = typer.Option(
        None, help="Address or file of a running Dask scheduler, whose workers are used instead."
    ),
) -> None:
    """Fit chosen parameters of a card to targets: strengths of grains, compression, onset of breakage."""
    # Not at the top: Dask, optuna and matplotlib would slow every other command.
    from grus.calibrate import calibrate as run
    from grus.calibrate import read_targets, summary, write_report

    card = Card.from_file(model)
    wanted = read_targets(targets, card)
    say = Console(stderr=True, highlight=False, soft_wrap=True).print
    try:
        with progress_bar("calibrating") as show:
            found = run(card, wanted, out, trials, jobs, scheduler, show, say)
    except KeyboardInterrupt:
        raise KeyboardInterrupt(
            f"interrupted; finished runs are kept in {Path(out)}, the same command goes on from there"
        ) from None
    result = write_report(found, out)
    print(summary(result))
    print(f"\nresults in {out}: {', '.join(result['files'])}")
