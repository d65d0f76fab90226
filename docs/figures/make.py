"""Makes the stored figures of the pages anew: PYTHONPATH=pkg /usr/bin/python3 docs/figures/make.py [FOLDER OF RESULTS]

The results of the thirty grains are kept in the folder when one is given.
"""

import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from matplotlib.figure import Figure

from grus.card import Card
from grus.crushing import CrushingResult, crush_group
from grus.crushing.picture import draw_fragments, fragment_picture
from grus.plotting import style, weibull_plot
from grus.specimen import draw

HERE = Path(__file__).resolve().parent
GRAINS = 30
SHOWN = 12


@style()
def before_and_after(result: CrushingResult) -> Figure:
    """The grain with its bonds at the start, and its fragments at the end."""
    figure = Figure(figsize=(7.2, 3.6), layout="constrained")
    left, right = figure.subplots(1, 2)
    draw(result.specimen, left, bonds=True)
    draw_fragments(right, result)
    left.set(
        xlim=right.get_xlim(), ylim=right.get_ylim(), xlabel="", ylabel="", xticks=[], yticks=[]
    )
    left.grid(False)
    left.set_title(f"{result.specimen.clump_count} clumps, {result.bonds} bonds")
    broken = result.tension_breaks + result.shear_breaks
    right.set_title(f"{result.after.fragment_count} fragments, {broken} bonds broken")
    return figure


def main(folder: Path) -> None:
    """Crushes the grains and writes the figures beside this file."""
    card = Card.from_file(HERE.parents[1] / "models" / "montesinho.toml")
    group = crush_group(card, GRAINS, folder)
    figures = {
        "grain": before_and_after(group.grains[0]),
        "fragments": fragment_picture(group.grains[:SHOWN]),
        "weibull": weibull_plot(group.weibull()),
    }
    for name, figure in figures.items():
        with style():
            figure.savefig(HERE / f"{name}.png", dpi=120, metadata={"Software": None})


if __name__ == "__main__":
    if len(sys.argv) > 1:
        main(Path(sys.argv[1]))
    else:
        with TemporaryDirectory() as temporary:
            main(Path(temporary))
