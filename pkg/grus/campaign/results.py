"""The table of a campaign with what was found."""

from collections.abc import Mapping, Sequence
from pathlib import Path

import pandas as pd

from grus.campaign.outcome import Outcome
from grus.campaign.table import Row
from grus.files import replacing


def results(rows: Sequence[Row], outcomes: Mapping[str, Outcome]) -> pd.DataFrame:
    """A row a run that was begun: key, kind, its changes to the card, what failed, seconds, and all figures, in SI."""
    lines = []
    for row in rows:
        outcome = outcomes.get(row.run.key)
        if outcome is not None:
            about = {"key": outcome.key, "kind": outcome.kind} | row.changes
            end = {"failed": outcome.failed or "", "seconds": outcome.seconds}
            lines.append(about | end | outcome.figures)
    return pd.DataFrame(lines)


def write_results(found: pd.DataFrame, path: Path) -> None:
    """As CSV, complete or not at all."""
    with replacing(path) as partial:
        found.to_csv(partial, index=False, float_format="%.9g")
