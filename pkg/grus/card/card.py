"""The model card: the only way in which parameters enter Grus."""

import copy
import os
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, Literal

from pydantic import PrivateAttr, ValidationError

from grus.card import canonical, toml_file
from grus.card.ageing import Ageing
from grus.card.agglomerate import Agglomerate
from grus.card.bond import Bond
from grus.card.consistency import inconsistencies
from grus.card.contact import Contact
from grus.card.crush import Crush
from grus.card.defaults import with_defaults
from grus.card.element import Element
from grus.card.errors import CardError, Problem
from grus.card.explain import explain
from grus.card.interval import POSITIVE
from grus.card.oedometer import Oedometer
from grus.card.overrides import overridden
from grus.card.preparation import Preparation
from grus.card.pydantic_adapter import Section, key, problems_of
from grus.card.quantity import Measure, Quantity
from grus.card.specimen import Specimen
from grus.card.table import Table
from grus.card.unknown import schema, split
from grus.card.values import Choice, Text, Whole
from grus.card.wetting import Wetting

MOST_SEED = 2**31 - 1  # of an engine's int


class Card(Section):
    """A checked, immutable model card in SI, made by `from_file` or `from_dict`."""

    name: str = key(Text("a text in quotes", 80), "Name of the model.")
    description: str | None = key(
        Text("a text in quotes", 2000, lines=True),
        "What the model stands for.",
        default=None,
        default_text="none",
    )
    dimension: Literal[2, 3] = key(Choice((2, 3)), "2: discs in a plane; 3: spheres.")
    thickness: Measure | None = key(
        Quantity({"m": "a length"}, POSITIVE, "1 m"),
        "Thickness of a plane model.",
        default=None,
        default_text="1 m in the plane, else left out",
    )
    seed: int = key(
        Whole(0, MOST_SEED), "Seed from which, with ids, every random number follows.", default=1
    )
    element: Element = key(Table(Element), "Elementary discs or spheres.")
    contact: Contact = key(Table(Contact), "Where two elements touch.")
    bond: Bond = key(Table(Bond), "Cement between the clumps of a grain.")
    agglomerate: Agglomerate = key(Table(Agglomerate), "Outline of a grain, and its clumps.")
    crush: Crush = key(Table(Crush), "Crushing of a grain between two platens.")
    specimen: Specimen | None = key(
        Table(Specimen), "Grains in the box of an oedometer.", default=None, default_text="none"
    )
    preparation: Preparation | None = key(
        Table(Preparation),
        "How that specimen comes to be.",
        default=None,
        default_text="all defaults where there is a specimen, else none",
    )
    oedometer: Oedometer | None = key(
        Table(Oedometer), "Oedometer test.", default=None, default_text="none"
    )
    ageing: Ageing | None = key(
        Table(Ageing), "Bonds that lose strength with time.", default=None, default_text="none"
    )
    wetting: Wetting | None = key(
        Table(Wetting), "What water does to the bonds.", default=None, default_text="none"
    )

    _source: str = PrivateAttr("")
    _directory: Path = PrivateAttr(Path())
    _written: dict = PrivateAttr({})

    @classmethod
    def from_file(cls, path: str | os.PathLike) -> "Card":
        """Card in a TOML file; CardError when the file or anything in it is wrong."""
        return cls.from_dict(toml_file.read(path), source=str(path), directory=Path(path).parent)

    @classmethod
    def from_dict(
        cls, card: Mapping[str, Any], source: str = "card", directory: str | os.PathLike = "."
    ) -> "Card":
        """Card from nested tables as a TOML file would hold them.

        `source` names the card in messages; a relative path of a mesh counts from `directory`.
        Raises CardError.
        """
        if not isinstance(card, Mapping) or not card:
            reason = "no keys, not a model card" if isinstance(card, Mapping) else "not a table"
            raise CardError.of(
                source, [Problem(reason, "the keys that `grus card --explain` lists")]
            )
        known, problems = split(card, cls)
        try:
            made = cls(**with_defaults(known))
        except ValidationError as error:
            problems += problems_of(error)
        else:
            made._source, made._directory = source, Path(directory).absolute()
            made._written = copy.deepcopy(known)
            problems += made._mesh_problems()
        if problems:
            raise CardError.of(source, [_complete(problem) for problem in problems], card)
        return made

    @property
    def source(self) -> str:
        """Where the card came from, as messages name it."""
        return self._source

    @property
    def written(self) -> dict[str, Any]:
        """The keys that were given, as they were given."""
        return copy.deepcopy(self._written)

    @property
    def mesh_path(self) -> Path | None:
        """Absolute path of the mesh of the grain outline, None without one."""
        mesh = self.agglomerate.mesh
        return None if mesh is None else self._directory / mesh

    def to_dict(self) -> dict[str, Any]:
        """Nested tables in SI, defaults written out; `from_dict` makes an equal card of them."""
        plain = canonical.plain(self)
        if self.mesh_path is not None:
            plain["agglomerate"]["mesh"] = str(self.mesh_path)
        return plain

    def content_hash(self) -> str:
        """SHA-256 of what decides results.

        Name, description, units, order of keys, and whether a default is written do not count.
        """
        return canonical.content_hash(self.to_dict())

    def with_overrides(self, overrides: Mapping[str, Any]) -> "Card":
        """Another card with some keys changed, e.g. {"bond.tensile_strength": "2 MPa"}.

        None takes a key out. Raises CardError.
        """
        changed = overridden(self._written, overrides, self._source)
        return Card.from_dict(changed, self._source, self._directory)

    def explain(self) -> str:
        """Every key: value in SI and as written, default, what is allowed, meaning."""
        return explain(schema(Card), self, self._written)

    @classmethod
    def explain_schema(cls) -> str:
        """The same without a card: every key, default, what is allowed, meaning."""
        return explain(schema(cls))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Card) and self.to_dict() == other.to_dict()

    def __hash__(self) -> int:
        return hash(self.content_hash())

    def _mesh_problems(self) -> list[Problem]:
        if self.mesh_path is None or self.mesh_path.is_file():
            return []
        return [Problem(f"no such file in {self._directory}", key="agglomerate.mesh")]

    @staticmethod
    def problems(section: Any) -> Iterator[Problem]:
        yield from inconsistencies(section)


def _complete(problem: Problem) -> Problem:
    """The problem with what is allowed for its key, where it does not say so itself."""
    known = dict(schema(Card)).get(problem.key)
    if problem.allowed or known is None:
        return problem
    return Problem(problem.reason, known.reader.allowed, problem.key)
