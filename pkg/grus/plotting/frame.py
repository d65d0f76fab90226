"""An empty plot, with room for a key below it that can never hide data."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure

SINGLE = (5.2, 4.0)
"""Width and height of a plot in inches, its key not included."""

_KEY_FONT = 7.5
_ROW = 0.148
_KEY_MARGIN = 0.22


def new_figure(size: tuple[float, float] = SINGLE, key_rows: int = 0) -> tuple[Figure, Axes]:
    """Figure and axes of (width, height) inches, with so many rows added below for ``draw_key``.

    Made outside pyplot: no display is needed and no figure stays open. Call it inside ``style()``.
    """
    room = _ROW * key_rows + _KEY_MARGIN if key_rows else 0.0
    height = size[1] + room
    figure = Figure(figsize=(size[0], height), layout="constrained")
    figure.get_layout_engine().set(rect=(0.0, room / height, 1.0, size[1] / height))
    return figure, figure.add_subplot()


def draw_key(figure: Figure, handles: Sequence[Artist], labels: Sequence[str]) -> None:
    """One row per label in the room below the plot; a handle may be invisible for a row of text."""
    figure.legend(
        handles,
        labels,
        loc="lower center",
        bbox_to_anchor=(0.5, 0.0),
        fontsize=_KEY_FONT,
        labelspacing=0.35,
        handlelength=1.6,
    )
