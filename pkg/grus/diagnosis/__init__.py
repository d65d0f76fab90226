"""What physics a model leaves out, told from a recording of a laboratory test."""

from grus.diagnosis.diagnose import diagnose
from grus.diagnosis.diagnosis import Diagnosis

__all__ = ["Diagnosis", "diagnose"]
