"""Names of a package that are imported at their first use, so that nobody waits for libraries that are not wanted."""

from collections.abc import Callable, Mapping
from importlib import import_module


def at_first_use(package: str, modules: Mapping[str, str]) -> Callable[[str], object]:
    """`__getattr__` of a package. modules: by each name, the module that has it, or is it.

    What it returns raises AttributeError for other names.
    """

    def get(name: str) -> object:
        if name not in modules:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        module = import_module(modules[name])
        return module if modules[name] == f"{package}.{name}" else getattr(module, name)

    return get
