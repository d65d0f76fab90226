"""`grus verify`: check the laws against formulas and against YADE's own."""

from pathlib import Path

import typer
from rich.console import Console

from grus.commands.progress import progress_bar


def verify(
    out: str = typer.Option(..., help="Folder for verification.json and the figures."),
) -> None:
    """Check the laws in YADE against formulas, YADE's own laws and the balance of energy."""
    from grus import verification  # not at the top: it loads YADE

    Path(out).mkdir(parents=True, exist_ok=True)
    with progress_bar("verifying") as show:
        found = verification.verify(out, show)
    verification.print_table(found, Console())
    print(f"results in {out}: verification.json, blocks.png, deviations.png (both also as SVG)")
    if not found.passed:
        raise typer.Exit(1)
