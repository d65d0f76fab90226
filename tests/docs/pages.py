"""The pages as the tests see them."""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
ALL = sorted(path for path in DOCS.rglob("*.md") if "_build" not in path.parts)


def text(path: Path) -> str:
    """A page without its blocks of code."""
    return re.sub(r"^(`{3,})[^\n]*\n.*?^\1$", "", path.read_text("utf-8"), flags=re.DOTALL | re.M)


def code_words(path: Path) -> list[str]:
    """What stands between single backticks in a page."""
    return re.findall(r"`([^`\n]+)`", text(path))


def titles(path: Path, level: int) -> list[str]:
    """Headings of a level."""
    return re.findall(rf"^{'#' * level} (.+)$", text(path), re.M)
