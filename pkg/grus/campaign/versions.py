"""What a result was made with."""

import platform

from grus.version import __version__


def versions() -> dict[str, str]:
    """Versions of Grus, YADE and Python by name."""
    from yade import config

    return {"grus": __version__, "yade": config.version, "python": platform.python_version()}
