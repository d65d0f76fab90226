"""`grus oedometer`: load a specimen stage by stage."""

from typing import Optional

import typer

from grus.commands.model import MODEL, SET, model_card
from grus.commands.staged_progress import staged_progress


def oedometer(
    model: str = MODEL,
    settings: list[str] = SET,
    out: str = typer.Option(..., help="Folder for the results."),
    specimens: Optional[str] = typer.Option(
        None,
        help="Folder that prepared specimens are taken from and put into.",
        show_default="that of the results",
    ),
    resume: bool = typer.Option(
        True,
        "--resume/--restart",
        help="Go on where an earlier run of this card was cut off, or begin the test anew.",
    ),
) -> None:
    """Prepare the specimen of a card and load it in an oedometer, stage by stage."""
    # Not at the top: matplotlib and VTK would slow every other command.
    from grus.oedometer import Analysis, summary, write_report
    from grus.oedometer import oedometer as run

    card = model_card(model, settings)
    with staged_progress() as show:
        result = run(card, out, show, specimens, restart=not resume)
    analysis = Analysis.of(result)
    found = write_report(result, out, analysis)
    print(summary(result, analysis))
    print(f"\nresults in {out}: {', '.join(found['files'])}")
