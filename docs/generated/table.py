"""Tables of docutils, with cells written as in the docstrings of YADE's classes."""

import re
from collections.abc import Sequence

from docutils import nodes
from sphinx import addnodes

from grus.host.load import load

YADE_CLASSES = "https://yade-dem.org/doc/yade.wrapper.html#yade.wrapper."
_MARKED = re.compile(r":yref:`(?:([^`<]+)<)?([^`>]+)>?`|``([^`]+)``")


def inline(text: str) -> list[nodes.Node]:
    """Text in which :yref:`Class.member`, :yref:`title<Class.member>` and ``code`` are marked."""
    found: list[nodes.Node] = []
    end = 0
    for match in _MARKED.finditer(text):
        found.append(nodes.Text(text[end : match.start()]))
        title, target, code = match.groups()
        found.append(nodes.literal("", code) if code else class_link(target, title))
        end = match.end()
    return [*found, nodes.Text(text[end:])]


def class_link(target: str, title: str | None = None) -> nodes.Node:
    """Link to the page of a class of Grus, or to YADE's manual for one of its own."""
    name, shown = target.partition(".")[0], nodes.literal("", title or target)
    if name not in load():
        return nodes.reference("", "", shown, refuri=YADE_CLASSES + target)
    page = {"refdomain": "std", "reftype": "doc", "reftarget": f"/classes/{name}"}
    return addnodes.pending_xref("", shown, refexplicit=True, refwarn=True, **page)


def literal(text: str) -> list[nodes.Node]:
    """A cell of code; an empty one for no text."""
    return [nodes.literal("", text)] if text else []


def table(
    heads: Sequence[str], widths: Sequence[int], rows: Sequence[Sequence[list[nodes.Node]]]
) -> nodes.table:
    """A table of cells, each a list of inline nodes; widths in any unit."""
    group = nodes.tgroup(cols=len(heads))
    group += [nodes.colspec(colwidth=width) for width in widths]
    group += nodes.thead("", _row([[nodes.Text(head)] for head in heads]))
    group += nodes.tbody("", *(_row(row) for row in rows))
    return nodes.table("", group, classes=["colwidths-given"])


def _row(cells: Sequence[list[nodes.Node]]) -> nodes.row:
    return nodes.row("", *(nodes.entry("", nodes.paragraph("", "", *cell)) for cell in cells))
