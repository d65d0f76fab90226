"""Staged compression of a specimen in an oedometer."""

from grus.oedometer.analysis import Analysis
from grus.oedometer.laboratory import laboratory
from grus.oedometer.report import write_report
from grus.oedometer.result import OedometerResult, StageEnd
from grus.oedometer.run import oedometer
from grus.oedometer.summary import summary
from grus.oedometer.test import OedometerTest

__all__ = [
    "Analysis",
    "OedometerResult",
    "OedometerTest",
    "StageEnd",
    "laboratory",
    "oedometer",
    "summary",
    "write_report",
]
