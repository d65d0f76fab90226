"""One screen about a diagnosis."""

from rich.console import Group, RenderableType
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from grus.diagnosis.diagnosis import Diagnosis
from grus.diagnosis.report.words import answers

WIDTH = 120
"""Columns that a text uses at most."""
COLOURS = {"nothing": "green", "named": "red", "cannot_tell": "yellow", "unknown": "magenta"}


def summary(diagnosis: Diagnosis) -> RenderableType:
    """The verdict and the answers to the first questions, at most 25 lines of 80 columns or more."""
    told = answers(diagnosis)
    table = Table.grid(padding=(0, 2, 0, 0))
    table.add_column(style="bold", no_wrap=True)
    table.add_column(max_width=WIDTH)
    for question, answer in told.by_question.items():
        table.add_row(question, Text(answer))
    verdict = Text(told.verdict, style=f"bold {COLOURS[diagnosis.verdict]}")
    return Group(Padding(verdict, (0, 0, 1, 0)), table)
