"""Tables of the keys of a model card."""

from docutils import nodes
from docutils.parsers.rst import Directive
from generated.table import inline, literal, table

from grus.card import Card
from grus.card.pydantic_adapter import Key
from grus.card.table import Table
from grus.card.unknown import schema

TOP = "top"


def sections() -> list[str]:
    """Names of the tables of a card, as in its TOML headers, after one for the keys above them."""
    return [TOP, *(name for name, key in schema(Card) if isinstance(key.reader, Table))]


class Keys(Directive):
    """`keys SECTION`: the keys of one table of the card; `top` for those above all tables."""

    required_arguments = 1
    has_content = True

    def run(self) -> list[nodes.Node]:
        """Nodes of the table; an error names a section that the card does not have."""
        section = self.arguments[0]
        if section not in sections():
            raise self.error(f"keys {section}: not in a card; allowed: {', '.join(sections())}")
        rows = [
            _row(name, key)
            for name, key in schema(Card)
            if (name.rpartition(".")[0] or TOP) == section and not isinstance(key.reader, Table)
        ]
        return [table(("Key", "Default", "Allowed", "Meaning"), (22, 18, 26, 34), rows)]


def _row(name: str, key: Key) -> tuple[list[nodes.Node], ...]:
    example = getattr(key.reader, "example", "")
    allowed = key.reader.allowed + (f', for example ``"{example}"``' if example else "")
    default = key.default or "none, needed"
    return literal(name.rpartition(".")[2]), inline(default), inline(allowed), inline(key.meaning)
