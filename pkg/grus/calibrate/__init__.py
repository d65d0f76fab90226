"""Fitting parameters of a card to what laboratory tests show."""

from importlib import import_module

from grus.calibrate.calibration import Calibration
from grus.calibrate.read import read_targets
from grus.calibrate.report import write_report
from grus.calibrate.summary import summary
from grus.calibrate.targets import Target, Targets

__all__ = [
    "Calibration",
    "Target",
    "Targets",
    "calibrate",
    "read_targets",
    "summary",
    "write_report",
]


def __getattr__(name: str) -> object:
    # At first use, so that a page about results does not wait for Dask and optuna.
    if name != "calibrate":
        raise AttributeError(f"module 'grus.calibrate' has no attribute '{name}'")
    return import_module("grus.calibrate.conduct").calibrate
