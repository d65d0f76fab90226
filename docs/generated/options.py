"""Tables of the arguments and options of a command."""

import click
import typer
from docutils import nodes
from docutils.parsers.rst import Directive
from generated.table import inline, literal, table

from grus.commands import app


def commands() -> dict[str, click.Command]:
    """Commands of `grus` by name."""
    return typer.main.get_command(app).commands


class Options(Directive):
    """`options COMMAND`: how the command is called."""

    required_arguments = 1
    has_content = True

    def run(self) -> list[nodes.Node]:
        """Nodes of usage and table; an error names a command that Grus does not have."""
        name = self.arguments[0]
        known = commands()
        if name not in known:
            raise self.error(f"options {name}: no command; allowed: {', '.join(known)}")
        command = known[name]
        context = click.Context(command, info_name=f"grus {name}")
        usage = f"grus {name} " + " ".join(command.collect_usage_pieces(context))
        parts: list[nodes.Node] = [nodes.literal_block(usage, usage, language="text")]
        if rows := [_row(parameter, context) for parameter in command.params]:
            parts.append(table(("Argument or option", "Default", "Meaning"), (30, 20, 50), rows))
        return parts


def _row(parameter: click.Parameter, context: click.Context) -> tuple[list[nodes.Node], ...]:
    name = ", ".join(parameter.opts)
    if isinstance(parameter, click.Argument):
        name = parameter.make_metavar()
    elif not parameter.is_flag:
        name += f" {parameter.make_metavar()}"
    return literal(name), inline(_default(parameter)), inline(_meaning(parameter))


def _default(parameter: click.Parameter) -> str:
    if parameter.required:
        return "none, needed"
    shown = getattr(parameter, "show_default", None)
    if isinstance(shown, str):
        return shown
    if getattr(parameter, "is_flag", False):
        both = parameter.opts if parameter.default else parameter.secondary_opts
        return f"``{both[0]}``" if parameter.secondary_opts else "off"
    return "none" if parameter.default is None else f"``{parameter.default}``"


def _meaning(parameter: click.Parameter) -> str:
    text = parameter.help
    if isinstance(parameter.type, click.IntRange):
        text += f" Allowed: {parameter.type._describe_range()}."
    return text
