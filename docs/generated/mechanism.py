"""Tables of the parameters of a mechanism."""

from docutils import nodes
from docutils.parsers.rst import Directive
from generated.table import inline, literal, table

from grus.mechanisms import MECHANISMS, Parameter


class MechanismTable(Directive):
    """`mechanism NAME`: what it acts on and its parameters."""

    required_arguments = 1
    has_content = True

    def run(self) -> list[nodes.Node]:
        """Nodes of a sentence and a table; an error names a mechanism that Grus does not have."""
        name = self.arguments[0]
        if name not in MECHANISMS:
            raise self.error(f"mechanism {name}: unknown; allowed: {', '.join(MECHANISMS)}")
        one = MECHANISMS[name]
        says = nodes.paragraph("", "", *inline(f"``{name}`` acts on the {one.acts_on}."))
        heads = ("Parameter", "Unit", "Bounds", "No effect", "Sizes of the fingerprint", "Meaning")
        return [says, table(heads, (18, 8, 14, 10, 16, 34), [_row(p) for p in one.parameters])]


def _row(one: Parameter) -> tuple[list[nodes.Node], ...]:
    return (
        literal(one.name),
        literal(one.unit),
        inline(f"{one.low:g} to {one.high:g}"),
        inline("" if one.off is None else f"{one.off:g}"),
        inline(", ".join(f"{size:g}" for size in one.sizes)),
        inline(one.meaning),
    )
