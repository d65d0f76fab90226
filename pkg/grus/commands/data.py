"""`grus data`: public recordings of laboratory tests."""

from enum import Enum
from pathlib import Path
from typing import Optional

import click
import typer
from rich.console import Console
from rich.table import Table

from grus.record import Record


class Action(str, Enum):
    """What is done with the recordings."""

    LIST = "list"
    FETCH = "fetch"
    SHOW = "show"


def data(
    action: Action = typer.Argument(
        ...,
        help="list: name the recordings; fetch: get one or all; show: draw one with its segments.",
    ),
    name: Optional[str] = typer.Argument(
        None, help="Name of the recording.", show_default="all, to fetch"
    ),
    folder: Optional[str] = typer.Option(
        None,
        "--from",
        help="Folder to take the files from instead of the network; their checksums are compared.",
        show_default="the origin",
    ),
    out: Optional[str] = typer.Option(None, help="Folder for the plot and the recording."),
) -> None:
    """List, fetch and show public recordings of laboratory tests."""
    if action == Action.SHOW and (name is None or out is None):
        raise click.UsageError("show needs a NAME and --out", click.get_current_context())
    if action != Action.SHOW and out is not None:
        raise click.UsageError("--out goes with show", click.get_current_context())
    if action == Action.LIST and (name is not None or folder is not None):
        raise click.UsageError("list needs neither a NAME nor --from", click.get_current_context())
    # Not at the top: spreadsheets and the network would slow every other command.
    from grus import public_data

    if action == Action.LIST:
        _list()
    elif action == Action.FETCH:
        for one in [name] if name else public_data.DATASETS:
            print(f"{one}: {public_data.fetch(one, folder)}")
    else:
        _show(name, folder, Path(out))


def _list() -> None:
    from grus.public_data import DATASETS, is_kept

    for origin in dict.fromkeys(one.origin for one in DATASETS.values()):
        print(f"{origin.repository}, licence {origin.licence}")
        print(f"  cite: {origin.citation}\n  from: {origin.page}\n  note: {origin.caution}")
        for one in (one for one in DATASETS.values() if one.origin == origin):
            here = "here" if is_kept(one.name) else "not fetched"
            print(f"  {one.name:<16} {one.test} ({here})")
            print(f"  {'':<16} {one.file}, SHA-256 {one.sha256}")
        print()


def _show(name: str, folder: str | None, out: Path) -> None:
    from dataclasses import replace

    from grus.plotting import save
    from grus.plotting.recording import recording_plot
    from grus.public_data import load
    from grus.recording import segments, write

    record = load(name, folder)
    record = replace(record, segments=segments(record))
    out.mkdir(parents=True, exist_ok=True)
    save(recording_plot(record, name), out / name)
    write(record, out / f"{name}.csv")
    _print(record)
    print(f"\nresults in {out}: {name}.csv, {name}.png, {name}.svg")


def _print(record: Record) -> None:
    table = Table(box=None, pad_edge=False)
    for title in ("stage", "kind", "readings", "time h", "stress kPa", "strain %"):
        table.add_column(title, justify="left" if title == "kind" else "right")
    for one in record.segments:
        change = 100 * (record["axial_strain"][one.last] - record["axial_strain"][one.first])
        time = "" if one.t0 is None else f"{one.t0 / 3600:.4g} to {one.t1 / 3600:.4g}"
        table.add_row(
            str(one.stage),
            one.kind,
            str(one.last - one.first + 1),
            time,
            f"{one.stress_from / 1e3:.4g} to {one.stress_to / 1e3:.4g}",
            f"{change:+.3f}",
        )
    Console().print(table)
    print()
    for note in record.notes:
        print(f"note: {note}")
    print(f"cite: {record.meta['citation']} ({record.meta['licence']})")
