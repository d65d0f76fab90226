"""The table of a test, simulated or real."""

from grus.record.record import Record

__all__ = ["Record"]
