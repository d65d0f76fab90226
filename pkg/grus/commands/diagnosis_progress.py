"""Progress of a diagnosis, told from the lines it says."""

import re

from grus.commands.staged_progress import Show

PARTS = {
    "calibrating stiffness": 0.03,
    "calibrating strength": 0.15,
    "base": 0.1,
    "without breakage": 0.03,
    "ordinary parameters": 0.09,
    "fingerprints": 0.5,
    "put back": 0.1,
}
"""Kinds of runs in the order of the work, each with about its share of it."""
_COUNT = re.compile(r"(.+): (\d+) of (\d+) runs")


class DiagnosisProgress:
    """Called with each line; passes the line on with the share of the work that is done."""

    def __init__(self, show: Show) -> None:
        self.show, self.share, self.line = show, 0.0, ""

    def __call__(self, line: str) -> None:
        count = _COUNT.fullmatch(line)
        if count and count[1] in PARTS:
            before = sum(list(PARTS.values())[: list(PARTS).index(count[1])])
            done, of = int(count[2]), int(count[3])
            # Several strengths are tried, each with runs of its own.
            self.share = max(self.share, before + PARTS[count[1]] * done / max(of, 1))
        self.show(min(self.share, 1.0), line)
