"""The table of a test, simulated or real."""

from grus.record.record import Record
from grus.record.segment import KINDS, Kind, Segment

__all__ = ["KINDS", "Kind", "Record", "Segment"]
