"""One screen about a campaign."""

from collections.abc import Mapping, Sequence

import numpy as np
from rich.table import Table

from grus.campaign.outcome import Outcome
from grus.campaign.table import Row
from grus.oedometer.evenly import evenly

ROWS = 20
"""Settings in the table at most."""
SHOWN = {
    "crush": {
        "strength MPa": ("peak.strength", 1e-6),
        "bonds broken": ("bonds.broken", 1),
        "fragments": ("fragments", 1),
    },
    "oedometer": {
        "yield kPa": ("yield.stress", 1e-3),
        "onset kPa": ("onset.stress", 1e-3),
        "K0": ("K0.final", 1),
        "bonds broken": ("bonds.broken", 1),
    },
    "recording": {
        "void ratio": ("void_ratio.final", 1),
        "K0": ("K0.final", 1),
        "bonds broken": ("bonds.broken", 1),
    },
}
"""Column -> figure and factor from SI."""
REPEATED = ("seed", "grain")
"""Changes that are not a setting of their own: runs that differ in nothing else are put together."""


def screen(rows: Sequence[Row], outcomes: Mapping[str, Outcome]) -> Table:
    """A line a setting: how many runs, and of their figures the mean and the standard deviation."""
    settings = _settings(rows)
    names = list(dict.fromkeys(name for setting in settings for name, _ in setting))
    columns = SHOWN[rows[0].run.kind]
    table = Table(box=None, pad_edge=False)
    for name in names:
        table.add_column(name.rpartition(".")[2], justify="right", no_wrap=True)
    for name in ("runs", "failed", *columns):
        table.add_column(name, justify="right")
    lines = list(settings.items())
    for number in evenly(len(lines), ROWS):
        setting, own = lines[number]
        ended = [outcomes[row.run.key] for row in own if row.run.key in outcomes]
        good = [outcome for outcome in ended if outcome.failed is None]
        counts = [str(len(ended)), str(len(ended) - len(good))]
        figures = [_figure(good, *column) for column in columns.values()]
        table.add_row(*(str(dict(setting).get(name, "")) for name in names), *counts, *figures)
    return table


def _settings(rows: Sequence[Row]) -> dict[tuple, list[Row]]:
    """Rows by what they change but seed and grain."""
    found: dict[tuple, list[Row]] = {}
    for row in rows:
        setting = tuple(item for item in row.changes.items() if item[0] not in REPEATED)
        found.setdefault(setting, []).append(row)
    return found


def _figure(outcomes: list[Outcome], name: str, factor: float) -> str:
    values = [factor * one.figures[name] for one in outcomes if name in one.figures]
    if not values:
        return "-"
    mean = f"{np.mean(values):.4g}"
    return mean if len(values) == 1 else f"{mean} ± {np.std(values, ddof=1):.2g}"
