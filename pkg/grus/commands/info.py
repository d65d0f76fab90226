"""`grus info`: what is installed, and what is supported."""

import platform
import sys
from importlib.metadata import PackageNotFoundError, version

from grus.host.load import SUPPORTED

LIBRARIES = ("numpy", "scipy", "pandas", "matplotlib", "shapely", "pint", "pydantic", "typer")


def info() -> None:
    """Show the versions of Grus, YADE, Python and the libraries, and which YADEs are supported."""
    for name, found in versions().items():
        print(f"{name:<12}{found}")
    print(f"{'supported':<12}{SUPPORTED}")


def versions() -> dict[str, str]:
    """Version of each part by its name, 'not found' for one that is not installed."""
    import grus  # not at the top: it loads YADE

    yade = sys.modules.get("yade")
    return {
        "grus": getattr(grus, "__version__", "not found"),
        "YADE": yade.config.version if yade else "not found",
        "Python": platform.python_version(),
        **{name: _version(name) for name in LIBRARIES},
    }


def _version(library: str) -> str:
    try:
        return version(library)
    except PackageNotFoundError:
        return "not found"
