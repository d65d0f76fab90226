"""Crushable rockfill in YADE. Importing it loads YADE and makes Grus's classes known to it."""

from grus.host.load import load

__version__ = "0.1.0"

globals().update(load())
