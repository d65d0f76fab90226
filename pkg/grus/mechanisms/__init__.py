"""Mechanisms: what a real oedometer test has and a plain run leaves out. One file each; this folder is the list."""

from importlib import import_module
from pkgutil import iter_modules

from grus.mechanisms.mechanism import Mechanism, Parameter

_ORDER = (
    "bond_ageing",
    "wall_friction",
    "platen_compliance",
    "hertzian_contact",
    "contact_plasticity",
    "rolling_resistance",
    "strength_scatter",
    "wetting_collapse",
    "loading_too_fast",
    "instrument_drift",
)
"""In which they are listed; others follow by name."""


def _found() -> dict[str, Mechanism]:
    modules = (import_module(f"{__name__}.{one.name}") for one in iter_modules(__path__))
    found = {one.MECHANISM.name: one.MECHANISM for one in modules if hasattr(one, "MECHANISM")}
    names = [name for name in _ORDER if name in found] + sorted(set(found) - set(_ORDER))
    return {name: found[name] for name in names}


MECHANISMS: dict[str, Mechanism] = _found()
"""By name."""

__all__ = ["MECHANISMS", "Mechanism", "Parameter"]
