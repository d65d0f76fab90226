"""Version of Grus."""

__version__ = "0.2.0"
