"""Recordings of laboratory tests: reading them, cutting them into segments, writing them."""

from grus.recording.alignment import read_program
from grus.recording.errors import RecordingError
from grus.recording.read import read
from grus.recording.segments import segments
from grus.recording.write import write

__all__ = ["RecordingError", "read", "read_program", "segments", "write"]
