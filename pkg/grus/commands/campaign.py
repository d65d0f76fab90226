"""`grus campaign`: many runs of a card."""

from enum import Enum
from typing import Optional

import typer
from rich.console import Console

from grus.card import Card
from grus.commands.model import MODEL
from grus.commands.progress import progress_bar


class Kind(str, Enum):
    """What is simulated."""

    CRUSH = "crush"
    OEDOMETER = "oedometer"
    RECORDING = "recording"


class Plan(str, Enum):
    """How points are spread."""

    SOBOL = "sobol"
    LATIN_HYPERCUBE = "latin-hypercube"


def campaign(
    model: str = MODEL,
    out: str = typer.Option(
        ...,
        help="Folder of the store; a campaign that was cut off goes on, and others may share it.",
    ),
    kind: Kind = typer.Option(
        Kind.CRUSH, help="crush: a grain; oedometer: a specimen; recording: without its analysis."
    ),
    seeds: Optional[str] = typer.Option(
        None, help="Seeds, as 1-40 or 1-10,20.", show_default="that of the card"
    ),
    grains: int = typer.Option(1, min=1, help="Grains of each card and seed, to crush."),
    choice: list[str] = typer.Option(
        [], "--set", help="Key and values, as bond.kind=parallel,contact; several make a grid."
    ),
    plan: Plan = typer.Option(Plan.SOBOL, help="How the points of --vary are spread."),
    vary: list[str] = typer.Option([], help="Key and range, as bond.tensile_strength=1..3 MPa."),
    points: int = typer.Option(16, min=1, help="Number of points of --vary."),
    jobs: Optional[int] = typer.Option(
        None, min=1, help="Runs at a time on this machine.", show_default="one a core"
    ),
    scheduler: Optional[str] = typer.Option(
        None, help="Address or file of a running Dask scheduler, whose workers are used instead."
    ),
    time_limit: Optional[float] = typer.Option(
        None, help="Minutes that a run may take.", show_default="none"
    ),
    memory_limit: Optional[float] = typer.Option(
        None, help="Gigabytes that a run may take.", show_default="equal parts"
    ),
) -> None:
    """Simulate a table of runs, as many at a time as there are cores, or on a cluster."""
    # Not at the top: Dask would slow every other command.
    from grus.campaign import Store
    from grus.campaign import campaign as run
    from grus.campaign import options
    from grus.campaign.plan import grid, spread
    from grus.campaign.results import results, write_results
    from grus.campaign.screen import screen
    from grus.campaign.table import table

    card = Card.from_file(model)
    taken = {"seed"} if seeds else set()
    chosen = options.named(map(options.choices, choice), taken)
    settings = grid(chosen)
    if vary:
        ranges = options.named(map(options.span, vary), taken | set(chosen))
        points_of = spread(plan.value, ranges, points, card.seed)
        settings = [one | other for one in settings for other in points_of]
    rows = table(kind.value, card, settings, seeds and options.seeds(seeds), grains)
    store = Store(out)
    with progress_bar("simulating") as show:
        outcomes = run(
            [row.run for row in rows],
            store,
            jobs,
            scheduler,
            None if time_limit is None else 60 * time_limit,
            None if memory_limit is None else int(1e9 * memory_limit),
            show,
            tell=Console(stderr=True, highlight=False, soft_wrap=True).print,
        )
    write_results(results(rows, outcomes), store.folder / "runs.csv")
    Console(highlight=False).print(screen(rows, outcomes))
    for outcome in [one for one in outcomes.values() if one.failed][:5]:
        print(f"failed: {outcome.key[:12]}: {outcome.failed}")
    print(f"\nresults in {out}: runs.csv, runs/")
