"""verification.json, the figures, the printed table and the exit code."""

import json
from dataclasses import replace
from io import StringIO

import pytest
from rich.console import Console

import grus.verification
from grus.commands import main
from grus.verification import Verification, print_table

KEYS = {
    "part": str,
    "case": str,
    "quantity": str,
    "unit": str,
    "expected": float,
    "got": (float, type(None)),
    "deviation": (float, type(None)),
    "tolerance": (float, int, type(None)),
    "passed": (bool, type(None)),
    "note": str,
}


@pytest.fixture
def failing(verification):
    """The same table, but with one expectation that is 1 % off."""
    first = verification.rows[0]
    wrong = replace(first, expected=1.01 * first.expected, deviation=0.01 / 1.01)
    return Verification((wrong, *verification.rows[1:]), verification.curves)


def test_files(verification, folder):
    names = {"verification.json"} | {
        f"{name}.{kind}" for name in ("blocks", "deviations") for kind in ("png", "svg")
    }
    assert {path.name for path in folder.iterdir()} == names
    assert (folder / "blocks.png").read_bytes().startswith(b"\x89PNG")


def test_json(verification, folder):
    data = json.loads((folder / "verification.json").read_text())
    assert set(data) == {"format", "passed", "counted", "failed", "versions", "rows"}
    assert data["format"] == "grus verification 1"
    assert data["passed"] is True and data["failed"] == 0
    assert set(data["versions"]) == {"grus", "yade", "python"}
    assert len(data["rows"]) == len(verification.rows)
    assert data["counted"] == sum(row["passed"] is not None for row in data["rows"])
    for row in data["rows"]:
        assert set(row) == set(KEYS)
        for key, kind in KEYS.items():
            assert isinstance(row[key], kind), (key, row)


def test_json_of_a_failure(failing):
    data = failing.to_dict()
    assert data["passed"] is False and data["failed"] == 1
    assert data["rows"][0]["passed"] is False


def test_plain_table(verification):
    text = StringIO()
    print_table(verification, Console(file=text, width=40))
    lines = text.getvalue().splitlines()
    for row in verification.rows:
        assert any(line.startswith(row.case) and row.quantity in line for line in lines)
    assert "\x1b" not in text.getvalue() and "FAIL" not in text.getvalue()
    assert lines[-1].endswith("only inform") and "all within tolerance" in lines[-1]


def test_table_on_a_terminal(failing):
    text = StringIO()
    print_table(failing, Console(file=text, width=160, force_terminal=True))
    assert "\x1b" in text.getvalue() and "FAIL" in text.getvalue()
    assert "1 out of tolerance" in text.getvalue()


def use(monkeypatch, verification):
    asked = []

    def verify(folder, progress):
        asked.append(folder)
        progress(1, 1)
        return verification

    monkeypatch.setattr(grus.verification, "verify", verify)
    return asked


def test_command(monkeypatch, capsys, verification):
    asked = use(monkeypatch, verification)
    assert main(["verify", "--out", "somewhere"]) == 0
    assert asked == ["somewhere"]
    assert "results in somewhere: verification.json" in capsys.readouterr().out


def test_command_with_a_row_out_of_tolerance(monkeypatch, capsys, failing):
    use(monkeypatch, failing)
    assert main(["verify", "--out", "somewhere"]) == 1
    out = capsys.readouterr().out
    assert f"FAIL: {failing.rows[0].case}" in out and "1 out of tolerance" in out


def test_command_needs_a_folder(capsys):
    assert main(["verify"]) == 2
    assert "--out" in capsys.readouterr().err
