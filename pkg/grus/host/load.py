"""Load YADE and make Grus's classes known to it."""

import builtins
import contextlib
import importlib
import io
import os
import sys
from pathlib import Path
from types import ModuleType

from grus.host import locate

SUPPORTED = (
    "YADE 2023.02a (Debian 12) and 2025.2.0 (Debian 13), amd64, double, "
    "each with engines that scripts/build made there"
)
SHOWN_DIFFERENCES = 3


def import_yade() -> ModuleType:
    """YADE's package, imported without its greeting on standard output."""
    os.environ.setdefault("HOME", str(Path.home()))  # services have none, and YADE insists on it
    # As YADE's own program does: one thread unless more are asked for. OpenMP reads it when YADE loads it.
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    if not locate.importable():
        sys.path.append(str(locate.yade_folder()))
    # YADE sets attributes of it, and in a process that multiprocessing has started it may be a dictionary.
    vars(sys.modules["__main__"])["__builtins__"] = builtins
    with contextlib.redirect_stdout(io.StringIO()):
        return importlib.import_module("yade")


def refusal(yade: ModuleType, differences: list[str]) -> ImportError:
    """What stands in the way, in one line."""
    shown = ", ".join(differences[:SHOWN_DIFFERENCES])
    if len(differences) > SHOWN_DIFFERENCES:
        shown += f" and {len(differences) - SHOWN_DIFFERENCES} more"
    return ImportError(
        f"grus cannot use YADE {yade.config.version}: {shown}; supported: {SUPPORTED}"
    )


def import_engines(yade: ModuleType) -> ModuleType:
    """The extension module; it needs YADE in the process already."""
    try:
        return importlib.import_module("grus._engines")
    except ModuleNotFoundError:
        raise ImportError("grus is not built: its module _engines is missing (run cmake)") from None
    except ImportError as error:
        raise refusal(yade, [str(error)]) from None


def load(expected: dict | None = None) -> dict[str, type]:
    """Grus's classes by name, known to YADE, Python and archives. Later calls only return them.

    Nothing is registered unless the binary interface of the YADE at hand agrees with the one that
    Grus was compiled for. ``expected`` replaces single entries of the table that it is compared with
    (see ``_engines.check``). ImportError, in one line, says what was found and what is supported.
    """
    yade = import_yade()
    engines = import_engines(yade)
    differences = engines.check(expected or {})
    if differences:
        raise refusal(yade, differences)
    classes = {name: getattr(yade.wrapper, name) for name in engines.register()}
    publish(yade, classes)
    return classes


def publish(yade: ModuleType, classes: dict[str, type]) -> None:
    """Put the classes where YADE's own are: in ``yade``, and bare in a script that has those bare."""
    script = sys.modules["__main__"]
    homes = [yade]
    if getattr(script, "Serializable", None) is yade.wrapper.Serializable:
        homes.append(script)
    for home in homes:
        for name, cls in classes.items():
            setattr(home, name, cls)
    yade.__all__.extend(name for name in classes if name not in yade.__all__)
