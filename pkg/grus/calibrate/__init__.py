"""Fitting parameters of a card to what laboratory tests show."""

from grus.calibrate.calibration import Calibration
from grus.calibrate.read import read_targets
from grus.calibrate.report import write_report
from grus.calibrate.summary import summary
from grus.calibrate.targets import Target, Targets
from grus.lazy import at_first_use

__all__ = [
    "Calibration",
    "Target",
    "Targets",
    "calibrate",
    "read_targets",
    "summary",
    "write_report",
]

# A page about results does not wait for Dask and optuna.
__getattr__ = at_first_use(__name__, {"calibrate": "grus.calibrate.conduct"})
