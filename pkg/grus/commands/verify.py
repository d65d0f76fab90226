"""`grus verify`: check the laws against formulas and against YADE's own."""

import typer
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn


def verify(
    out: str = typer.Option(..., help="Folder for verification.json and the figures."),
) -> None:
    """Check the laws in YADE against formulas, YADE's own laws and the balance of energy."""
    from grus import verification  # not at the top: it loads YADE

    with Progress(
        TextColumn("verifying"),
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
        console=Console(stderr=True),
    ) as bar:
        task = bar.add_task("verifying", total=None)
        found = verification.verify(
            out, lambda done, of: bar.update(task, completed=done, total=of)
        )
    verification.print_table(found, Console())
    print(f"results in {out}: verification.json, blocks.png, deviations.png (both also as SVG)")
    if not found.passed:
        raise typer.Exit(1)
