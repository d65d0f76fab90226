"""`grus report`: one page about a folder of results."""

from pathlib import Path
from typing import Optional

import typer


def report(
    folder: str = typer.Argument(
        ...,
        help="Folder that grus crush, grus oedometer, grus campaign or grus calibrate has filled.",
    ),
    out: Optional[str] = typer.Option(
        None, help="File of the page.", show_default="report.html in the folder"
    ),
) -> None:
    """Make one page, in HTML that needs no other file, of any folder of results."""
    # Not at the top: matplotlib would slow every other command.
    from grus.report import content_of, write_page

    path = write_page(content_of(folder), out or Path(folder) / "report.html")
    print(f"page: {path}")
