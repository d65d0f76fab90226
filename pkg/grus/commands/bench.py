"""`grus bench`: how long a step takes."""

from enum import Enum

import typer
from rich.console import Console

from grus.commands.progress import progress_bar
from grus.errors import GrusError


class Kind(str, Enum):
    """What a block consists of."""

    SPHERES = "spheres"
    CLUMPS = "clumps"


def bench(
    out: str = typer.Option(
        ..., help="Folder for bench.json; a measurement that was cut off goes on."
    ),
    quick: bool = typer.Option(False, help="Three small blocks only; under a minute."),
    dimension: list[int] = typer.Option(
        [], min=2, max=3, help="Discs (2) or spheres (3); may be repeated.", show_default="both"
    ),
    kind: list[Kind] = typer.Option(
        [], help="Free elements or stamped clumps; may be repeated.", show_default="both"
    ),
    elements: list[int] = typer.Option(
        [],
        min=100,
        help="About how many; may be repeated.",
        show_default="1000, 10000, 50000, 150000",
    ),
    threads: list[int] = typer.Option(
        [], min=1, help="Threads; may be repeated.", show_default="1 and 2"
    ),
    resume: bool = typer.Option(
        True,
        "--resume/--restart",
        help="Keep what the folder has, or forget it and begin anew.",
        show_default="resume",
    ),
) -> None:
    """Time Grus's loops beside YADE's own laws, LAMMPS and ESyS-Particle on blocks of bonded grains."""
    from grus import bench  # not at the top: other commands need none of it

    chosen = {
        "dimensions": dimension,
        "elements": elements,
        "kinds": [one.value for one in kind],
        "threads": threads,
    }
    chosen = {name: values for name, values in chosen.items() if values}
    if quick and chosen:
        raise GrusError("--quick has cases of its own; leave it out to choose them")
    with progress_bar("measuring") as show:
        cases = bench.QUICK if quick else bench.cases(**chosen)
        found = bench.bench(cases, out, show, restart=not resume)
    bench.print_table(found, Console())
    print(f"results in {out}: bench.json")
