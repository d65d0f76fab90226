"""Crushable rockfill in YADE. Importing it loads YADE and makes Grus's classes known to it."""

from grus.host.load import load
from grus.lazy import at_first_use
from grus.version import __version__

_CLASSES = load()
globals().update(_CLASSES)

# A YADE script that only wants the engines does not wait for matplotlib and the rest.
_LATER = {
    "Card": "grus.card",
    "CrushingTest": "grus.crushing",
    "OedometerResult": "grus.oedometer",
    "OedometerTest": "grus.oedometer",
    "Specimen": "grus.specimen",
    "crush": "grus.crushing",
    "crush_group": "grus.crushing",
    "diagnose": "grus.diagnosis",
    "fit_weibull": "grus.statistics",
    "grain_from_card": "grus.specimen.from_card",
    "oedometer": "grus.oedometer",  # the package; its function of the same name would hide it
    "size_effect": "grus.statistics",
    "verify": "grus.verification",
    "write_report": "grus.crushing",
}

__all__ = sorted([*_CLASSES, *_LATER, "__version__"])

__getattr__ = at_first_use(__name__, _LATER)


def __dir__() -> list[str]:
    return __all__
