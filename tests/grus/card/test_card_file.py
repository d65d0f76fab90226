"""Files that are no cards, and those that are in spite of their looks."""

import os

import pytest

from grus.card import Card

START = b"name = 'a'\ndimension = 2\n"

BROKEN = {
    "empty": (b"", "no keys"),
    "comments only": (b"# nothing\n\n", "no keys"),
    "no equals sign": (b"name", "not valid TOML"),
    "open quote": (b'name = "abc', "not valid TOML"),
    "open bracket": (b"[element", "not valid TOML"),
    "value missing": (b"seed =\n", "not valid TOML"),
    "duplicate key": (b"seed = 1\nseed = 2\n", "not valid TOML"),
    "duplicate table": (b"[element]\n[element]\n", "not valid TOML"),
    "table over key": (b"element = 1\n[element]\nradius = 2\n", "not valid TOML"),
    "latin-1": ('name = "Tr\xe1s-os-Montes"\n'.encode("latin-1"), "not text in UTF-8 (line 1)"),
    "utf-16": ('name = "a"\n'.encode("utf-16"), "not text in UTF-8"),
    "binary": (bytes(range(256)), "not text in UTF-8"),
    "null byte": (b'name = "a\0b"', "not valid TOML"),
    "old Mac line ends": (b'name = "a"\rseed = 1\r', "not valid TOML"),
    "nested lists": (b"a = " + b"[" * 90_000, "nested too deeply"),
    "nested tables": (b"a = " + b"{a = " * 15_000, "nested too deeply"),
    "long dotted key": (b".".join([b"a"] * 5_000) + b" = 1", "unknown key"),
    "long integer": (b"seed = " + b"9" * 5000, "not valid TOML"),
    "long hexadecimal": (
        START + b"seed = 0x" + b"f" * 5000,
        "seed = an integer of about 6021 digits",
    ),
    "date": (START + b"seed = 2020-01-01", "seed = 2020-01-01: not a whole number"),
    "array of tables": (
        START + b"[[element]]",
        "element = a list of 1 items: not a table",
    ),
    "too large": (b"#" * 100_001, "too large for a model card"),
    "thousands of unknown keys": (b"".join(b"k%d = 1\n" % i for i in range(9_000)), "unknown key"),
    "json": (b'{"name": "a"}', "not valid TOML"),
}


@pytest.mark.parametrize("content, line", BROKEN.values(), ids=BROKEN)
def test_broken_file_is_told_in_one_line(tmp_path, refusal, content, line):
    path = tmp_path / "card.toml"
    path.write_bytes(content)
    message = refusal(Card.from_file, path)
    assert message.startswith(f"{path}: ") and line in message


@pytest.mark.parametrize("name", ["none.toml", "", ".", "..", "a\0b", "x" * 5000, "/dev/zero"])
def test_not_a_file(tmp_path, monkeypatch, refusal, name):
    monkeypatch.chdir(tmp_path)
    assert "allowed: " in refusal(Card.from_file, name)


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read everything")
def test_file_that_may_not_be_read(tmp_path, refusal):
    path = tmp_path / "card.toml"
    path.touch(mode=0o000)
    assert "Permission denied" in refusal(Card.from_file, path)


@pytest.mark.parametrize(
    "change",
    [
        lambda text: b"\xef\xbb\xbf" + text,
        lambda text: text.replace(b"\n", b"\r\n"),
        lambda text: text.rstrip(b"\n"),
    ],
)
def test_editors_may_differ(models, plane, tmp_path, change):
    path = tmp_path / "card.toml"
    path.write_bytes(change((models / "montesinho.toml").read_bytes()))
    assert Card.from_file(path) == plane
    assert Card.from_file(str(path)) == plane


def test_every_shipped_card_is_good(models):
    cards = sorted(models.glob("*.toml"))
    assert {"montesinho.toml", "montesinho-3d.toml"} <= {path.name for path in cards}
    for path in cards:
        assert Card.from_file(path).name == path.stem
