"""The table of all rows, and how it is written."""

import json
import platform
import sys
from dataclasses import dataclass
from pathlib import Path

from grus.files import write_text
from grus.plotting import save
from grus.verification.figures import block_figure, deviation_figure
from grus.verification.other_laws_block import Curves
from grus.verification.row import Row
from grus.version import __version__

FORMAT = "grus verification 1"


@dataclass(frozen=True)
class Verification:
    """All rows, in the order of the cases, and the force-displacement curves of the blocks by loading and law."""

    rows: tuple[Row, ...]
    curves: Curves

    @property
    def passed(self) -> bool:
        """Whether no row is out of its tolerance; rows that only inform do not count."""
        return not self.failed

    @property
    def failed(self) -> tuple[Row, ...]:
        return tuple(row for row in self.rows if row.passed is False)

    def to_dict(self) -> dict:
        """Plain JSON."""
        yade = sys.modules["yade"]
        return {
            "format": FORMAT,
            "passed": self.passed,
            "counted": sum(row.tolerance is not None for row in self.rows),
            "failed": len(self.failed),
            "versions": {
                "grus": __version__,
                "yade": yade.config.version,
                "python": platform.python_version(),
            },
            "rows": [row.to_dict() for row in self.rows],
        }

    def write(self, folder: str | Path) -> None:
        """Writes verification.json, blocks.png, deviations.png and both as SVG."""
        folder = Path(folder)
        folder.mkdir(parents=True, exist_ok=True)
        save(block_figure(self.curves), folder / "blocks")
        save(deviation_figure(self.rows), folder / "deviations")
        # Last, so that a verification.json stands for a complete folder.
        text = json.dumps(self.to_dict(), indent=1, allow_nan=False)
        write_text(folder / "verification.json", text + "\n")
