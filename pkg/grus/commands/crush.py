"""`grus crush`: crush a group of grains."""

from typing import Optional

import typer
from rich.console import Console

from grus.commands.model import MODEL, SET, model_card
from grus.commands.progress import progress_bar


def crush(
    model: str = MODEL,
    settings: list[str] = SET,
    grains: int = typer.Option(30, min=1, help="Number of grains."),
    jobs: Optional[int] = typer.Option(
        None, min=1, help="Grains crushed at a time.", show_default="one a core"
    ),
    out: str = typer.Option(..., help="Folder for the results; a run that was cut off goes on."),
) -> None:
    """Crush a group of grains between platens and fit their Weibull distribution."""
    # Not at the top: matplotlib and VTK would slow every other command.
    from grus.crushing import crush_group, summary, write_report

    card = model_card(model, settings)
    with progress_bar("crushing") as show:
        tell = Console(stderr=True, highlight=False, soft_wrap=True).print
        group = crush_group(card, grains, out, jobs, show, tell)
    result = write_report(group, out)
    print(summary(group))
    print(f"\nresults in {out}: {', '.join(result['files'])}")
    if group.failed:
        raise typer.Exit(1)
