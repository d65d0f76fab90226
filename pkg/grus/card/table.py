"""Tables inside the card."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from grus.card.errors import Problem
from grus.card.pydantic_adapter import Section, keys


@dataclass(frozen=True)
class Table:
    """A table with the keys of `section`."""

    section: type[Section]

    @property
    def allowed(self) -> str:
        return f"a table with keys out of {', '.join(keys(self.section))}"

    def read(self, value: Any) -> Any:
        if isinstance(value, self.section):
            return value
        if not isinstance(value, Mapping):
            raise Problem("not a table", self.allowed)
        return dict(value)
