"""scripts/grus, the command as a user has it."""

import os
import shutil
import signal
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]
SCRIPT = ROOT / "scripts" / "grus"
CARD = ROOT / "models" / "montesinho.toml"


def call(script, *arguments, **options):
    return subprocess.run(
        [script, *arguments], capture_output=True, text=True, timeout=120, **options
    )


def test_from_any_directory_and_through_links(tmp_path):
    (tmp_path / "first").symlink_to(SCRIPT)
    (tmp_path / "grus link").symlink_to(tmp_path / "first")
    # Modules of these names must not be taken for those of Python.
    for name in ("typing.py", "random.py", "grus.py"):
        (tmp_path / name).write_text("raise SystemExit('wrong module')")
    done = call(tmp_path / "grus link", "card", CARD, cwd=tmp_path)
    assert done.returncode == 0 and done.stderr == ""
    assert done.stdout.startswith(f"{CARD}: good; content hash ")


def test_bad_card(tmp_path):
    (tmp_path / "bad.toml").write_text(CARD.read_text().replace('"0.6 mm"', "0.6"))
    done = call(SCRIPT, "card", "bad.toml", cwd=tmp_path)
    assert done.returncode == 2 and done.stdout == ""
    assert done.stderr == (
        'grus: bad.toml: element.radius = 0.6: give a unit, for example "0.6 mm"; '
        "allowed: a length [m] > 0\n"
    )


def test_file_name_that_is_no_text(tmp_path):
    done = call(SCRIPT, "card", os.fsencode(tmp_path) + b"/\xff\n.toml")
    assert done.returncode == 2 and len(done.stderr.splitlines()) == 1


def test_engines_not_built(tmp_path):
    (tmp_path / "scripts").mkdir()
    (tmp_path / "pkg" / "grus").mkdir(parents=True)
    shutil.copy(SCRIPT, tmp_path / "scripts")
    done = call(tmp_path / "scripts" / "grus", "--help")
    assert done.returncode == 2 and done.stdout == ""
    assert done.stderr == f"grus: the engines are not built; run {tmp_path}/scripts/build\n"


def test_package_that_cannot_be_loaded(tmp_path):
    (tmp_path / "scripts").mkdir()
    package = tmp_path / "pkg" / "grus"
    package.mkdir(parents=True)
    (package / "_engines.so").touch()
    (package / "__init__.py").write_text("raise ImportError('no YADE')")
    shutil.copy(SCRIPT, tmp_path / "scripts")
    done = call(tmp_path / "scripts" / "grus", "--help")
    assert (done.returncode, done.stdout, done.stderr) == (2, "", "grus: no YADE\n")


def test_full_disk():
    with open("/dev/full", "w") as full:
        done = subprocess.run(
            [SCRIPT, "card", CARD], stdout=full, stderr=subprocess.PIPE, text=True, timeout=120
        )
    assert done.returncode == 2
    assert done.stderr == "grus: output: No space left on device\n"


def test_interrupt(tmp_path):
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    waiting = subprocess.Popen([SCRIPT, "card", pipe], stderr=subprocess.PIPE, text=True)
    with pipe.open("wb"):  # opens when the command, fully loaded, opens the other end
        waiting.send_signal(signal.SIGINT)
        _, said = waiting.communicate(timeout=120)
    assert waiting.returncode == 130 and said == "grus: interrupted\n"


@pytest.mark.parametrize("arguments", [["--help"], ["card", "--help"], ["info"]])
def test_help_and_info(arguments):
    done = call(SCRIPT, *arguments)
    assert done.returncode == 0 and done.stdout and done.stderr == ""
