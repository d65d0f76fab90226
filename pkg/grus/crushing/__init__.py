"""Crushing of single grains between rigid platens."""

from grus.crushing.group import GroupResult, crush_group
from grus.crushing.report import write_report
from grus.crushing.result import CrushingResult
from grus.crushing.summary import summary
from grus.crushing.test import CrushingTest, crush

__all__ = [
    "CrushingResult",
    "CrushingTest",
    "GroupResult",
    "crush",
    "crush_group",
    "summary",
    "write_report",
]
