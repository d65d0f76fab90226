"""The table of rows, for people."""

from collections.abc import Sequence

from rich.console import Console
from rich.table import Table
from rich.text import Text

from grus.verification.row import Row
from grus.verification.verification import Verification

OUTCOME = {True: ("pass", "green"), False: ("FAIL", "bold red"), None: ("info", "cyan")}
HEADS = ("quantity", "unit", "expected", "got", "deviation", "tolerance", "")


def print_table(verification: Verification, console: Console) -> None:
    """Prints one table a part, the notes of the rows that failed or only inform, and the outcome.

    In colour with lines on a terminal; elsewhere one plain line a row.
    """
    parts = dict.fromkeys(row.part for row in verification.rows)
    for part in parts:
        rows = [row for row in verification.rows if row.part == part]
        if console.is_terminal:
            console.print(_table(part, rows))
        else:
            console.print(Text(f"\n{part}"))
            _print_plain(rows, console)
    console.print()
    for row in verification.rows:
        if not row.passed:
            line = f"{OUTCOME[row.passed][0]}: {row.case}, {row.quantity}: {row.note}"
            console.print(Text(line), soft_wrap=not console.is_terminal)
    console.print(Text(summary(verification)), soft_wrap=True)


def summary(verification: Verification) -> str:
    """The outcome in one line."""
    counted = sum(row.tolerance is not None for row in verification.rows)
    failed = len(verification.failed)
    outcome = f"{failed} out of tolerance" if failed else "all within tolerance"
    return f"{counted} rows, {outcome}; {len(verification.rows) - counted} more only inform"


def cells(row: Row) -> tuple[str, ...]:
    """Texts of a row below HEADS."""
    tolerance = "" if row.tolerance is None else f"{row.tolerance:.0e}"
    return (
        row.quantity,
        row.unit,
        f"{row.expected:.6g}",
        f"{row.got:.6g}",
        f"{row.deviation:.1e}",
        tolerance,
        OUTCOME[row.passed][0],
    )


def _table(part: str, rows: Sequence[Row]) -> Table:
    table = Table(title=part, title_justify="left")
    table.add_column("case", overflow="fold")
    for head in HEADS:
        table.add_column(head, justify="left" if head in ("quantity", "unit", "") else "right")
    for row in rows:
        *texts, outcome = cells(row)
        table.add_row(row.case, *texts, Text(outcome, style=OUTCOME[row.passed][1]))
    return table


def _print_plain(rows: Sequence[Row], console: Console) -> None:
    lines = [("case", *HEADS), *((row.case, *cells(row)) for row in rows)]
    widths = [max(map(len, column)) for column in zip(*lines)]
    for line in lines:
        text = "  ".join(cell.ljust(width) for cell, width in zip(line, widths))
        console.print(Text(text.rstrip()), soft_wrap=True)
