"""Crushable rockfill in YADE. Importing it loads YADE and makes Grus's classes known to it."""

from importlib import import_module

from grus.host.load import load
from grus.version import __version__

_CLASSES = load()
globals().update(_CLASSES)

# Loaded at first use, so that a YADE script that only wants the engines does not wait for matplotlib and the rest.
_FUNCTIONS = {
    "Card": "grus.card",
    "CrushingTest": "grus.crushing",
    "OedometerResult": "grus.oedometer",
    "OedometerTest": "grus.oedometer",
    "Specimen": "grus.specimen",
    "crush": "grus.crushing",
    "crush_group": "grus.crushing",
    "fit_weibull": "grus.statistics",
    "grain_from_card": "grus.specimen.from_card",
    "size_effect": "grus.statistics",
    "verify": "grus.verification",
    "write_report": "grus.crushing",
}

_PACKAGES = ("oedometer",)
"""Whose function of the same name would hide them: `grus.oedometer.oedometer`."""

__all__ = sorted([*_CLASSES, *_FUNCTIONS, *_PACKAGES, "__version__"])


def __getattr__(name: str) -> object:
    if name in _PACKAGES:
        return import_module(f"grus.{name}")
    if name not in _FUNCTIONS:
        raise AttributeError(f"module 'grus' has no attribute '{name}'")
    return getattr(import_module(_FUNCTIONS[name]), name)


def __dir__() -> list[str]:
    return __all__
