"""The look of all figures, and how they are written."""

from __future__ import annotations

from contextlib import AbstractContextManager
from pathlib import Path

import matplotlib
import matplotlib.style
from cycler import cycler
from matplotlib.figure import Figure

from grus.files import replacing

# Okabe & Ito (2008): told apart with every common colour-vision deficiency. Its yellow is left out,
# because it is too light for lines on white.
BLUE = "#0072B2"
VERMILION = "#D55E00"
GREEN = "#009E73"
PURPLE = "#CC79A7"
ORANGE = "#E69F00"
SKY = "#56B4E9"
BLACK = "#000000"
GREY = "#7F7F7F"
PALETTE = (BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, BLACK)

BOX = {"facecolor": "white", "edgecolor": "#CCCCCC", "alpha": 0.9, "boxstyle": "square,pad=0.4"}
"""Frame of a text inside the axes, like that of a legend."""

_PARAMETERS = {
    "font.family": "DejaVu Sans",  # shipped with matplotlib, so the same everywhere
    "font.size": 9.5,
    "mathtext.fontset": "dejavusans",
    "axes.labelsize": 10,
    "axes.titlesize": 10.5,
    "axes.titlepad": 8,
    "axes.linewidth": 0.8,
    "axes.edgecolor": "#333333",
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.prop_cycle": cycler(color=PALETTE),
    "axes.xmargin": 0.03,
    "grid.color": "#DDDDDD",
    "grid.linewidth": 0.6,
    "xtick.direction": "out",
    "ytick.direction": "out",
    "xtick.labelsize": 9,
    "ytick.labelsize": 9,
    "lines.linewidth": 1.6,
    "lines.markersize": 4.5,
    "legend.fontsize": 8.5,
    "legend.frameon": True,
    "legend.framealpha": 0.9,
    "legend.edgecolor": "#CCCCCC",
    "legend.fancybox": False,
    "figure.constrained_layout.use": True,
    "savefig.dpi": 200,
    "svg.hashsalt": "grus",  # otherwise element ids differ from run to run
}


def style() -> AbstractContextManager:
    """Context or decorator: matplotlib draws in the style of Grus, whatever the user set."""
    return matplotlib.style.context(["default", _PARAMETERS])


def save(figure: Figure, path: str | Path) -> tuple[Path, Path]:
    """Write ``path``.png (200 dpi) and ``path``.svg; ``path`` has no suffix. Returns both paths.

    The same figure gives the same bytes (no dates, fixed ids). Each file appears complete or not at
    all. Missing folders are made.
    """
    stem = Path(path)
    stem.parent.mkdir(parents=True, exist_ok=True)
    png = stem.with_name(stem.name + ".png")
    svg = stem.with_name(stem.name + ".svg")
    with style():
        _write(figure, png, "png", {"Software": None})
        _write(figure, svg, "svg", {"Date": None, "Creator": None})
    return png, svg


def _write(figure: Figure, path: Path, kind: str, metadata: dict) -> None:
    with replacing(path) as partial:
        figure.savefig(partial, format=kind, metadata=metadata)
