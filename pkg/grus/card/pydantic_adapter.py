"""The one place that knows which pydantic is installed, 1.10 or 2."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from types import SimpleNamespace
from typing import Any

import pydantic
from pydantic import BaseModel, Field

from grus.card.errors import Problem, Problems

NEEDED = object()
_TWO = not pydantic.VERSION.startswith("1.")


@dataclass(frozen=True)
class Key:
    """What the schema says: how a key is read, its meaning, its default in words ('' if needed)."""

    reader: Any
    meaning: str
    default: str


def key(reader: Any, meaning: str, default: Any = NEEDED, default_text: str = "") -> Any:
    """Field of a section; `default` as a card would write it, None for a key that may be absent."""
    text = default_text or ("" if default is NEEDED else str(default).lower())
    kept = {"json_schema_extra": {"key": Key(reader, meaning, text)}}
    if default is NEEDED:
        return Field(..., **kept)
    return Field(default_factory=lambda: None if default is None else reader.read(default), **kept)


@lru_cache(maxsize=None)
def keys(section: type[BaseModel]) -> dict[str, Key]:
    """Keys of a section in the order of the schema."""
    fields = section.model_fields if _TWO else section.__fields__
    extras = {
        name: field.json_schema_extra if _TWO else field.field_info.extra["json_schema_extra"]
        for name, field in fields.items()
    }
    return {name: extra["key"] for name, extra in extras.items()}


class _Checked(BaseModel, extra="forbid", frozen=True, arbitrary_types_allowed=True):
    @staticmethod
    def problems(section: Any) -> Iterator[Problem]:
        """What is wrong between keys that are good one by one, named from this section on."""
        return iter(())

    @classmethod
    def _refuse(cls, values: Any) -> None:
        found = list(cls.problems(values))
        if found:
            raise Problems(found)


if _TWO:
    from pydantic import field_validator, model_validator

    class Section(_Checked):
        """A table of the card: immutable, unknown keys refused."""

        @field_validator("*", mode="before")
        @classmethod
        def _read(cls, value: Any, info: Any) -> Any:
            return keys(cls)[info.field_name].reader.read(value)

        @model_validator(mode="after")
        def _check(self) -> "Section":
            self._refuse(self)
            return self

    def _flat(error: pydantic.ValidationError) -> Iterator[tuple[tuple, Any]]:
        for entry in error.errors():
            yield entry["loc"], entry.get("ctx", {}).get("error", entry["type"])

else:
    from pydantic import root_validator, validator

    class Section(_Checked):
        """A table of the card: immutable, unknown keys refused."""

        @validator("*", pre=True)
        def _read(cls, value: Any, field: Any) -> Any:
            return keys(cls)[field.name].reader.read(value)

        @root_validator(skip_on_failure=True)
        def _check(cls, values: dict[str, Any]) -> dict[str, Any]:
            cls._refuse(SimpleNamespace(**values))
            return values

    def _flat(error: pydantic.ValidationError) -> Iterator[tuple[tuple, Any]]:
        for entry in error.raw_errors:
            loc = tuple(part for part in entry.loc_tuple() if part != "__root__")
            if isinstance(entry.exc, pydantic.ValidationError):
                yield from ((loc + inner, what) for inner, what in _flat(entry.exc))
            else:
                yield loc, getattr(entry.exc, "msg_template", entry.exc)


def problems_of(error: pydantic.ValidationError) -> list[Problem]:
    """Problems of a refused card, keys from its top."""
    found = []
    for loc, what in _flat(error):
        parent = ".".join(str(part) for part in loc)
        if isinstance(what, Problems):
            found += [problem.under(parent) for problem in what.found]
        elif isinstance(what, Problem):
            found.append(what.under(parent))
        else:
            missing = what in ("missing", "field required")
            found.append(Problem("is missing" if missing else str(what), key=parent))
    return found
