"""`grus crush`: crush a group of grains."""

from typing import Optional

import typer
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from grus.card import Card


def crush(
    model: str = typer.Argument(..., help="Model card, a file in TOML."),
    grains: int = typer.Option(30, min=1, help="Number of grains."),
    jobs: Optional[int] = typer.Option(
        None, min=1, help="Grains crushed at a time.", show_default="one a core"
    ),
    out: str = typer.Option(..., help="Folder for the results; a run that was cut off goes on."),
) -> None:
    """Crush a group of grains between platens and fit their Weibull distribution."""
    from grus.crushing import crush_group, summary, write_report  # not at the top: matplotlib, VTK

    card = Card.from_file(model)
    console = Console(stderr=True)
    with Progress(
        TextColumn("crushing"),
        BarColumn(),
        MofNCompleteColumn(),
        TimeRemainingColumn(),
        console=console,
    ) as bar:
        task = bar.add_task("crushing", total=grains)
        group = crush_group(
            card, grains, out, jobs, lambda done, of: bar.update(task, completed=done)
        )
    write_report(group, out)
    print(summary(group))
    print(
        f"\nresults in {out}: result.json, curves.csv, weibull.png, force-displacement.png, fragments.png, vtk/"
    )
