"""Command line: one file a command, each a few lines over the Python functions it stands for.

A new command is a file here and a line below.
"""

from collections.abc import Sequence

import typer

from grus.commands import (
    bench,
    calibrate,
    campaign,
    card,
    crush,
    data,
    diagnose,
    info,
    mechanisms,
    oedometer,
    prove,
    report,
    verify,
)
from grus.commands.run import run

app = typer.Typer(
    help="Crushable rockfill in YADE: make grains, crush them, load specimens of them in an oedometer.",
    add_completion=False,
    pretty_exceptions_enable=False,
)
app.command()(bench.bench)
app.command()(calibrate.calibrate)
app.command()(campaign.campaign)
app.command()(card.card)
app.command()(crush.crush)
app.command()(data.data)
app.command()(diagnose.diagnose)
app.command()(info.info)
app.command()(mechanisms.mechanisms)
app.command()(oedometer.oedometer)
app.command()(prove.prove)
app.command()(report.report)
app.command()(verify.verify)


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs `grus` with these arguments (those of the process by default); returns the exit code."""
    return run(app, arguments)
