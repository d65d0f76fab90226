"""Find the Python folder of the installed YADE, for plain python3. Run by the build, it prints the version."""

import importlib.util
import os
import re
import sys
import sysconfig
from pathlib import Path


def importable() -> bool:
    """True inside YADE's own program and where its Python folder is on ``sys.path`` already."""
    if "yade" in sys.modules:
        return True
    found = importlib.util.find_spec("yade")
    return found is not None and found.origin is not None


def yade_folder() -> Path:
    """Folder to put on ``sys.path``; ImportError, in one line, when there is no YADE.

    ``YADE_PREFIX`` (default ``/usr``) is where YADE is installed. Of several builds the one with
    Real = double is taken: its binary interface is the one that Grus is made for.
    """
    libraries = Path(os.environ.get("YADE_PREFIX", "/usr"), "lib")
    libraries /= sysconfig.get_config_var("MULTIARCH") or ""
    builds = [
        build for build in libraries.glob("yade*") if (build / "py/yade/__init__.py").exists()
    ]
    if not builds:
        raise ImportError(
            f"grus needs YADE, and there is none in {libraries}/yade*/py (YADE_PREFIX names another prefix)"
        )
    return min(builds, key=lambda build: (build.name != "yade-double", build.name)) / "py"


def installed_version() -> str:
    """Version of that YADE, which is not loaded; ImportError, in one line, as `yade_folder`."""
    config = (yade_folder() / "yade" / "config.py").read_text()
    return re.search(r"^version='(.+)'$", config, re.M)[1]


if __name__ == "__main__":
    try:
        print(installed_version())
    except ImportError as error:
        sys.exit(str(error))
