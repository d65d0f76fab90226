"""Crushing of single grains between rigid platens."""

from importlib import import_module

from grus.crushing.result import CrushingResult
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

_OF_GROUPS = {
    "GroupResult": "grus.crushing.group",
    "crush_group": "grus.crushing.group",
    "summary": "grus.crushing.screen",
    "write_report": "grus.crushing.report",
}


def __getattr__(name: str) -> object:
    # At first use, so that the processes of the simulations do not wait for statistics and plots.
    if name not in _OF_GROUPS:
        raise AttributeError(f"module 'grus.crushing' has no attribute '{name}'")
    return getattr(import_module(_OF_GROUPS[name]), name)
