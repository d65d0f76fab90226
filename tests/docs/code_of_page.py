"""Code that stands in a page: each block whose file is named right before it, in the manner of `folder/file.hpp`:

code_of_page.py PAGE FOLDER writes these files into the folder.
"""

import re
import sys
from pathlib import Path

_NAMED = re.compile(r"`([\w./]+)`:\n\n```\w+\n(.*?)```\n", re.DOTALL)


def files(page: str) -> dict[str, str]:
    """Content of each named file of a page."""
    return dict(_NAMED.findall(page))


def blocks(page: str, language: str) -> list[str]:
    """Content of each block of a language."""
    return re.findall(rf"^```{language}\n(.*?)^```$", page, re.DOTALL | re.MULTILINE)


if __name__ == "__main__":
    for name, content in files(Path(sys.argv[1]).read_text(encoding="utf-8")).items():
        path = Path(sys.argv[2], name)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content, encoding="utf-8")
