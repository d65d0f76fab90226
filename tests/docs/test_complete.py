"""Everything that users meet has its page, and every page of this kind ends in the same way."""

import pytest
from generated.keys import TOP, sections
from generated.options import commands
from pages import DOCS, titles

import grus
from grus.host.load import load
from grus.mechanisms import MECHANISMS

CLOSING = ["Restrictions", "Defaults", "What is saved", "Related"]
FOLDERS = ("theory", "classes", "card", "commands", "mechanisms")
CLOSED = [
    path
    for folder in FOLDERS
    for path in sorted((DOCS / folder).glob("*.md"))
    if path.name != "index.md"
] + [DOCS / "card" / "index.md"]


def names(folder: str) -> set[str]:
    """Names of the pages of a folder but its index."""
    return {path.stem for path in (DOCS / folder).glob("*.md")} - {"index"}


def test_every_class_has_its_page():
    assert names("classes") == set(load())


def test_every_command_has_its_page():
    assert names("commands") == set(commands())


def test_every_table_of_the_card_has_its_page():
    expected = {name.replace(".", "-").replace("_", "-") for name in sections() if name != TOP}
    assert names("card") == expected


def test_every_mechanism_has_its_page():
    assert names("mechanisms") == set(MECHANISMS)


@pytest.mark.parametrize("page", CLOSED, ids=lambda path: f"{path.parent.name}/{path.stem}")
def test_pages_end_with_the_four_sections(page):
    assert titles(page, 2)[-4:] == CLOSING


@pytest.mark.parametrize(
    "folder, directive, names",
    [
        ("classes", "attributes", load()),
        ("commands", "options", commands()),
        ("card", "keys", [name for name in sections() if name != TOP]),
        ("mechanisms", "mechanism", list(MECHANISMS)),
    ],
)
def test_every_page_shows_its_table(folder, directive, names):
    for name in names:
        page = (
            DOCS
            / folder
            / f"{name.replace('.', '-').replace('_', '-') if folder == 'card' else name}.md"
        )
        assert f"```{{{directive}}} {name}\n" in page.read_text("utf-8"), page


def test_titles_are_the_names():
    for name in load():
        assert titles(DOCS / "classes" / f"{name}.md", 1) == [name]
    for name in commands():
        assert titles(DOCS / "commands" / f"{name}.md", 1) == [f"grus {name}"]
    assert grus.__version__
