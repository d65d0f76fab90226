"""Failures a user can cause: one line on standard error and an exit code."""

import os

import pytest
import typer

from grus.commands.run import run
from grus.errors import GrusError


class Fails:
    """An application whose command `fail` raises what it is told to; `work` prints."""

    def __init__(self, error=None):
        self.app = typer.Typer(add_completion=False)

        @self.app.command()
        def fail() -> None:
            raise error

        @self.app.command()
        def work(count: int, flag: bool = False) -> None:
            print("done", count, flag)


@pytest.fixture
def outcome(capsys):
    """Runs an application; returns its exit code, output and the lines on standard error."""

    def run_it(app, *arguments):
        code = run(app, arguments)
        captured = capsys.readouterr()
        return code, captured.out, captured.err.splitlines()

    return run_it


def test_work_is_done(outcome):
    assert outcome(Fails().app, "work", "3", "--flag") == (0, "done 3 True\n", [])


@pytest.mark.parametrize(
    "error, code, line",
    [
        (
            GrusError("a.toml: x = 1: wrong; allowed: 2"),
            2,
            "grus: a.toml: x = 1: wrong; allowed: 2",
        ),
        (GrusError("two\nlines"), 2, "grus: two\\nlines"),
        (PermissionError(13, "Permission denied", "a.csv"), 2, "grus: a.csv: Permission denied"),
        (OSError(28, "No space left on device"), 2, "grus: output: No space left on device"),
        (OSError("strange"), 2, "grus: output: strange"),
        (KeyboardInterrupt(), 130, "grus: interrupted"),
    ],
)
def test_failure_is_one_line(outcome, error, code, line):
    assert outcome(Fails(error).app, "fail") == (code, "", [line])


def test_reader_gone_is_told_to_nobody(outcome):
    assert outcome(Fails(BrokenPipeError(32, "Broken pipe")).app, "fail") == (141, "", [])


def test_fault_of_grus_keeps_its_traceback():
    with pytest.raises(ZeroDivisionError):
        run(Fails(ZeroDivisionError()).app, ["fail"])


@pytest.mark.parametrize(
    "arguments, said",
    [
        ([], ["grus: missing command", "see grus --help"]),
        (["nothing"], ["grus: no such command 'nothing'"]),
        (["--nothing"], ["grus: no such option: --nothing"]),
        (["work"], ["grus work: missing argument 'COUNT'", "see grus work --help"]),
        (["work", "x"], ["grus work: invalid value for 'COUNT'", "'x'"]),
        (["work", "1", "2"], ["grus work: got unexpected extra argument (2)"]),
        (["work", "1", "--flg"], ["grus work: no such option: --flg", "--flag"]),
        (["work", "1", "--flag=2"], ["does not take a value"]),
        (["work", "a\nb"], ["grus work: invalid value"]),
    ],
)
def test_wrong_usage_is_one_line(outcome, arguments, said):
    code, out, err = outcome(Fails().app, *arguments)
    assert code == 2 and out == "" and len(err) == 1
    assert all(words in err[0] for words in said)


@pytest.mark.parametrize("arguments", [["--help"], ["work", "--help"]])
def test_help(outcome, arguments):
    code, out, err = outcome(Fails().app, *arguments)
    assert code == 0 and "Usage: grus" in out and not err


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="no /dev/full here")
def test_full_disk_is_told_once(capfd, monkeypatch):
    with open("/dev/full", "w") as full:
        monkeypatch.setattr("sys.stdout", full)
        assert run(Fails().app, ["work", "1"]) == 2
    assert capfd.readouterr().err == "grus: output: No space left on device\n"
