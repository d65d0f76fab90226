"""`grus bench`: how long a step takes."""

import typer
from rich.console import Console


def bench(
    out: str = typer.Option(..., help="Folder for bench.json."),
    quick: bool = typer.Option(False, help="Two small blocks only; under a minute."),
) -> None:
    """Time Grus's loops beside YADE's own laws on blocks of bonded grains."""
    from grus import bench  # not at the top: other commands need none of it

    found = bench.measure(
        bench.QUICK if quick else bench.FULL,
        lambda done, of: Console(stderr=True).print(f"measured {done} of {of} cases"),
    )
    bench.print_table(found, Console())
    print(f"results in {bench.write(out, found)}")
