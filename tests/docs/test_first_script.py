"""The pages "First script" and "First oedometer" are their scripts, and the scripts run."""

import os
import subprocess

import pytest
from code_of_page import blocks
from pages import DOCS, ROOT

import grus

PAGES = {"first-script.md": "crush.py", "first-oedometer.md": "oedometer.py"}
PAGE = (DOCS / "first-script.md").read_text("utf-8")
CARD = ROOT / "tests" / "cards" / "plane.toml"


def run(script: str, *arguments: object) -> str:
    """What a script prints."""
    done = subprocess.run(
        ["yade", "-n", "-x", str(ROOT / "scripts" / script), *map(str, arguments)],
        env=os.environ | {"PYTHONPATH": str(ROOT / "pkg"), "OMP_NUM_THREADS": "1"},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize("page, script", PAGES.items())
def test_pieces_of_the_page_are_the_script(page, script):
    pieces = blocks((DOCS / page).read_text("utf-8"), "python")
    assert "\n".join(pieces) == (ROOT / "scripts" / script).read_text("utf-8")


@pytest.mark.parametrize("script", ["crush.py", "oedometer.py", "prepare.py"])
def test_scripts_are_short(script):
    assert len((ROOT / "scripts" / script).read_text("utf-8").splitlines()) < 80


def test_script_crushes_the_grain_of_the_page():
    said = run("crush.py", ROOT / "models" / "montesinho.toml")
    shown = blocks(PAGE, "text")[0].splitlines()
    assert shown[0] in said and shown[2] in said and "ended: " in said


def test_script_crushes_as_grus_does():
    grain = grus.crush(grus.Card.from_file(CARD), 1)
    said = run("crush.py", CARD, 1)
    assert f"strength {grain.strength / 1e6:.7g} MPa" in said
    assert f"{grain.tension_breaks} bonds broken in tension, {grain.shear_breaks} in shear" in said


def test_scripts_prepare_and_load_as_grus_does(tmp_path):
    """The prepared specimen of one script is that of the other and of Grus, and so are the stages."""
    (tmp_path / "prepared").mkdir()
    run("prepare.py", CARD, tmp_path / "prepared")
    (made,) = (tmp_path / "prepared").iterdir()
    result = grus.oedometer.oedometer(grus.Card.from_file(CARD), tmp_path / "grus")
    assert made.read_bytes() == (tmp_path / "grus" / made.name).read_bytes()
    said = run("oedometer.py", CARD, tmp_path / "prepared")
    assert "growing" not in said
    for end in result.stages:
        strain, breaks = f"void ratio {end.void_ratio:.6f}", f"{end.breaks} bonds broken"
        assert f"{end.target / 1e3:g} kPa: " in said and f"{strain}, {breaks}" in said
    written = {path.name for path in (tmp_path / "prepared").iterdir()}
    assert {"record.csv", "stage-000.vtp", "stage-003.vtp"} <= written
