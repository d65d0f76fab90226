"""Crushing of single grains between rigid platens."""

from grus.crushing.result import CrushingResult
from grus.crushing.test import CrushingTest, crush
from grus.lazy import at_first_use

__all__ = [
    "CrushingResult",
    "CrushingTest",
    "GroupResult",
    "crush",
    "crush_group",
    "summary",
    "write_report",
]

# At first use, so that the processes of the simulations do not wait for statistics and plots.
__getattr__ = at_first_use(
    __name__,
    {
        "GroupResult": "grus.crushing.group",
        "crush_group": "grus.crushing.group",
        "summary": "grus.crushing.screen",
        "write_report": "grus.crushing.report",
    },
)
