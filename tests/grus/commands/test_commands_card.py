"""`grus card` and `grus info`."""

from pathlib import Path

import pytest

from grus.card import Card
from grus.commands import main
from grus.commands.info import versions
from grus.host.load import SUPPORTED

MODELS = Path(__file__).resolve().parents[3] / "models"
GOOD = str(MODELS / "montesinho.toml")


def test_good_card(capsys):
    assert main(["card", GOOD]) == 0
    captured = capsys.readouterr()
    digest = Card.from_file(GOOD).content_hash()
    assert captured.out == f"{GOOD}: good; content hash {digest[:12]}\n" and not captured.err


def test_explain_a_card(capsys):
    assert main(["card", GOOD, "--explain"]) == 0
    assert capsys.readouterr().out == Card.from_file(GOOD).explain() + "\n"


def test_explain_the_schema(capsys):
    assert main(["card", "--explain"]) == 0
    assert capsys.readouterr().out == Card.explain_schema() + "\n"


@pytest.mark.parametrize("text", ["", "[", "name = 1", "\0", "a" * 200_000])
@pytest.mark.parametrize("explain", [[], ["--explain"]])
def test_bad_card_is_one_line(capsys, tmp_path, text, explain):
    (tmp_path / "card.toml").write_text(text)
    assert main(["card", str(tmp_path / "card.toml"), *explain]) == 2
    captured = capsys.readouterr()
    assert captured.out == "" and len(captured.err.splitlines()) == 1
    assert captured.err.startswith(f"grus: {tmp_path}/card.toml: ")


def test_no_file_is_asked_for(capsys):
    assert main(["card"]) == 2
    assert capsys.readouterr().err == (
        "grus card: give a FILE to check, or --explain to see the schema; see grus card --help\n"
    )


def test_missing_file_is_named(capsys):
    assert main(["card", "no such file.toml"]) == 2
    assert capsys.readouterr().err.startswith(
        "grus: no such file.toml: cannot be read: No such file"
    )


def test_info_names_all_versions(capsys):
    assert main(["info"]) == 0
    out = capsys.readouterr().out
    lines = out.splitlines()
    assert [line.split()[0] for line in lines] == [*versions(), "supported"]
    assert {"grus", "YADE", "Python", "numpy", "pydantic"} <= set(versions())
    assert "not found" not in out and f"supported   {SUPPORTED}" in lines
