"""Staged compression of a specimen in an oedometer."""

from grus.oedometer.result import OedometerResult, StageEnd
from grus.oedometer.run import oedometer
from grus.oedometer.test import OedometerTest

__all__ = ["OedometerResult", "OedometerTest", "StageEnd", "oedometer"]
