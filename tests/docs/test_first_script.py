"""The page "First script" is the script, and the script runs."""

import os
import subprocess

from code_of_page import blocks
from pages import DOCS, ROOT

SCRIPT = ROOT / "scripts" / "crush_one.py"
PAGE = (DOCS / "first-script.md").read_text("utf-8")


def test_pieces_of_the_page_are_the_script():
    assert "\n".join(blocks(PAGE, "python")) == SCRIPT.read_text("utf-8")


def test_script_crushes_the_grain():
    done = subprocess.run(
        ["yade", "-n", "-x", str(SCRIPT)],
        env=os.environ | {"PYTHONPATH": str(ROOT / "pkg")},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    shown = blocks(PAGE, "text")[0].splitlines()
    assert shown[0] in done.stdout and "ended: crushed" in done.stdout
