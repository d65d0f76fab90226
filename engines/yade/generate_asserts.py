"""Write static_asserts that hold the headers to a reduced layout table.

    generate_asserts.py layout/VERSION-ARCHITECTURE.json > layout_asserts.hpp
"""

import json
import sys
from collections.abc import Iterator
from pathlib import Path


def asserts(table: dict) -> Iterator[str]:
    """One line per size, alignment and position."""
    for name, (size, align) in table["types"].items():
        yield f'static_assert(sizeof(yade::{name}) == {size} && alignof(yade::{name}) == {align}, "{name}");'
    for name, entry in table["classes"].items():
        size, align = entry["size"], entry["align"]
        yield f'static_assert(sizeof(yade::{name}) == {size} && alignof(yade::{name}) == {align}, "{name}");'
        for member, offset in entry["members"].items():
            yield f'static_assert(offsetof(yade::{name}, {member}) == {offset}, "{name}.{member}");'


if __name__ == "__main__":
    lines = list(asserts(json.loads(Path(sys.argv[1]).read_text())))
    print("#pragma once", *lines, sep="\n")
    print(f"// {len(lines)} assertions")
