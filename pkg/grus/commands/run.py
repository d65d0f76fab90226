"""Running a command so that every failure a user can cause is one line and an exit code.

0: done; 2: refused input, wrong usage, or output that cannot be written; 130: interrupted;
141: nobody reads the output any more. An error of Grus itself keeps its traceback.
"""

import os
import sys
from collections.abc import Sequence
from typing import Any

import click
import typer

from grus.errors import GrusError, one_line

DONE, REFUSED, INTERRUPTED, UNREAD = 0, 2, 130, 141


def run(app: typer.Typer, arguments: Sequence[str] | None = None) -> int:
    """Exit code of `app` with these arguments (those of the process by default)."""
    return _flushed(_outcome(app, sys.argv[1:] if arguments is None else arguments))


def _outcome(app: typer.Typer, arguments: Sequence[str]) -> int:
    command = typer.main.get_command(app)
    try:
        with command.make_context("grus", list(arguments)) as context:
            command.invoke(context)
    except click.exceptions.Exit as end:  # of --help, for one
        return end.exit_code
    except click.ClickException as error:
        return _refuse(*_usage(error))
    except GrusError as error:
        return _refuse("grus", error)
    except (KeyboardInterrupt, click.Abort) as stop:
        return _refuse("grus", str(stop) or "interrupted", INTERRUPTED)
    except BrokenPipeError:
        return UNREAD
    except OSError as error:
        return _refuse("grus", _failure(error))
    return DONE


def _usage(error: click.ClickException) -> tuple[str, str]:
    """Command and complaint, in one line instead of click's several."""
    context = getattr(error, "ctx", None)
    command = context.command_path if context else "grus"
    complaint = " ".join(error.format_message().split()).rstrip(".")
    return command, f"{complaint[:1].lower()}{complaint[1:]}; see {command} --help"


def _failure(error: OSError) -> str:
    return f"{error.filename or 'output'}: {error.strerror or error}"


def _refuse(who: str, what: Any, code: int = REFUSED) -> int:
    print(f"{who}: {one_line(what)}", file=sys.stderr)
    return code


def _flushed(code: int) -> int:
    """`code`, or another one when the rest of the output cannot be written."""
    try:
        if sys.stdout is not None:
            sys.stdout.flush()
    except OSError as error:
        # What is left would fail again at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        if isinstance(error, BrokenPipeError):
            return code or UNREAD
        return code or _refuse("grus", _failure(error))
    return code
