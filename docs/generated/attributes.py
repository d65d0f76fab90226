"""Tables of a YADE class: what can be set, what can be read, what can be called."""

import re
from typing import Any

from docutils import nodes
from docutils.parsers.rst import Directive
from generated.table import class_link, inline, literal, table

from grus.host.load import load

# What the attribute macros of the engines append to each docstring.
_ROLES = re.compile(r"(.*) :ydefault:`.*?` :yattrtype:`(.*)` :yattrflags:`(\d+)` ", re.DOTALL)
_READONLY = 2
_TYPES = {
    "Real": "float",
    "std::string": "str",
    "Vector2r": "Vector2",
    "Vector3r": "Vector3",
}


class Attributes(Directive):
    """`attributes CLASS`: everything that Python can see of a class of Grus."""

    required_arguments = 1
    has_content = True

    def run(self) -> list[nodes.Node]:
        """Nodes of the tables; an error names a class that Grus does not have."""
        name = self.arguments[0]
        if name not in load():
            raise self.error(f"attributes {name}: no class of Grus; allowed: {', '.join(load())}")
        cls = load()[name]
        parts = [_heritage(cls)]
        writable, readable = _attributes(cls)
        for title, rows in {"To be set": writable, "To be read only": readable}.items():
            if rows:
                parts += [nodes.rubric("", title), _attribute_table(rows)]
        if calls := _calls(cls):
            parts += [nodes.rubric("", "Functions and further values")]
            parts += [table(("Name", "Meaning"), (25, 75), calls)]
        return parts


def _heritage(cls: type) -> nodes.paragraph:
    """The base class, and which of its defaults are other ones here."""
    base = cls.__mro__[1]
    made, usual = cls().dict(), base().dict()
    other = [
        f"{name} = {_shown(made[name])}"
        for name in usual
        if _shown(made[name]) != _shown(usual[name])
    ]
    text = "; all its attributes are here as well"
    text += f", with other defaults: {', '.join(f'``{one}``' for one in other)}." if other else "."
    return nodes.paragraph("", "", nodes.Text("Base: "), class_link(base.__name__), *inline(text))


def _attributes(cls: type) -> tuple[list, list]:
    """Rows of the attributes that can be set, and of those that can only be read."""
    rows: tuple[list, list] = ([], [])
    defaults = cls().dict()
    for name, member in vars(cls).items():
        match = _ROLES.fullmatch(getattr(member, "__doc__", None) or "")
        if match:
            meaning, kind, flags = match.groups()
            row = (literal(name), _type(kind), literal(_shown(defaults[name])), inline(meaning))
            rows[bool(int(flags) & _READONLY)].append(row)
    return rows


def _attribute_table(rows: list) -> nodes.table:
    return table(("Attribute", "Type", "Default", "Meaning"), (22, 14, 12, 52), rows)


def _calls(cls: type) -> list:
    """Rows of functions and of properties that are computed when asked for."""
    rows = []
    for name, member in vars(cls).items():
        text = getattr(member, "__doc__", None) or ""
        if name.startswith("__") or ":yattrflags:" in text:
            continue
        if not isinstance(member, property):
            # Boost.Python puts the signature first.
            name, text = f"{name}()", text.partition(":\n")[2]
        rows.append((literal(name), inline(text.strip())))
    return rows


def _type(kind: str) -> list[nodes.Node]:
    """A C++ type as Python sees it."""
    if match := re.fullmatch(r"boost::shared_ptr<(\w+)>", kind):
        return [class_link(match[1])]
    if match := re.fullmatch(r"std::vector<(\w+)>", kind):
        return [nodes.Text("list of "), *_type(match[1])]
    return literal(_TYPES.get(kind, kind))


def _shown(value: Any) -> str:
    """A default as a script would write it."""
    if isinstance(value, float):
        return f"{value:g}"
    if hasattr(value, "__len__") and not isinstance(value, (str, list)):
        return f"({', '.join(map(_shown, value))})"
    return repr(value)
