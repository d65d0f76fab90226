"""`grus info`: what is installed."""

import platform
import sys
from importlib.metadata import PackageNotFoundError, version

LIBRARIES = ("numpy", "scipy", "pandas", "matplotlib", "shapely", "pint", "pydantic", "typer")


def info() -> None:
    """Show the versions of Grus, YADE, Python and the libraries."""
    for name, found in versions().items():
        print(f"{name:<12}{found}")


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
