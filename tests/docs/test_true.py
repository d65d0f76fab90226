"""What the pages name exists."""

import re
import tomllib

import pytest
from code_of_page import blocks, files
from pages import ALL, DOCS, ROOT, code_words, text

import grus
from grus.card import Card
from grus.host.load import load

FOLDERS = ("docs", "engines", "models", "pkg", "scripts", "tests", "validation")
SOURCES = ("engines", "pkg", "scripts", "tests", "docs/generated")
SUFFIXES = (".hpp", ".cpp", ".py", ".cmake", ".txt", ".toml", ".css", "")
PLACEHOLDER = re.compile(r"NAME|VERSION|SECTION|COMMAND|CLASS|\.\.\.|\*|/_build")

page_of = {"ids": lambda path: str(path.relative_to(DOCS))}


@pytest.mark.parametrize("page", ALL, **page_of)
def test_files_exist(page):
    made = files(page.read_text("utf-8"))  # a page may show the files that its reader is to write
    for word in code_words(page):
        first = word.split()[0]
        if first.split("/")[0] not in FOLDERS or "/" not in first or PLACEHOLDER.search(first):
            continue
        assert first in made or (ROOT / first).exists(), f"{word}: no such file"


@pytest.mark.parametrize("page", ALL, **page_of)
def test_attributes_exist(page):
    for word in code_words(page):
        match = re.fullmatch(r"(\w+)\.(\w+)", word)
        if match and match[1] in load():
            assert match[2] in load()[match[1]]().dict(), f"{word}: no such attribute"


@pytest.fixture(scope="module")
def source() -> str:
    """All sources in one text."""
    paths = (
        path
        for folder in SOURCES
        for path in (ROOT / folder).rglob("*")
        if path.is_file() and path.suffix in SUFFIXES and "__pycache__" not in path.parts
    )
    return "\n".join(
        [(ROOT / "CMakeLists.txt").read_text(), *(p.read_text("utf-8") for p in paths)]
    )


@pytest.mark.parametrize("page", ALL, **page_of)
def test_names_occur_in_the_sources(page, source):
    for word in code_words(page):
        if (
            PLACEHOLDER.search(word)
            or "/" in word
            or word.startswith("-")
            or (ROOT / word).exists()
        ):
            continue
        for name in re.findall(r"[A-Za-z_]\w{2,}", word):
            assert name in source, f"{word}: {name} is in no source"


def flat(tables: dict, parent: str = "") -> dict:
    """Keys of nested tables by their dotted names."""
    result = {}
    for name, value in tables.items():
        inner = isinstance(value, dict)
        result |= flat(value, f"{parent}{name}.") if inner else {parent + name: value}
    return result


def test_cards_are_good():
    whole = blocks((DOCS / "card" / "index.md").read_text("utf-8"), "toml")
    card = Card.from_dict(tomllib.loads(whole[0]))
    for page in (DOCS / "card").glob("*.md"):
        for block in blocks(page.read_text("utf-8"), "toml"):
            card.with_overrides(flat(tomllib.loads(block)))


def test_everything_public_is_named():
    words = {word for page in ALL for word in re.findall(r"\w+", text(page))}
    assert sorted(set(grus.__all__) - {"__version__"} - words) == []
