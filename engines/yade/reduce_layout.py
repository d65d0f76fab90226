"""Reduce a full table of YADE's binary layout to the classes that include/ declares.

    reduce_layout.py FULL.json > layout/VERSION-ARCHITECTURE.json

Member positions are bytes from the start of the object. Reference members are left out: C++ cannot
ask for their position. For Python-visible members the table also keeps the type, for the load guard.
"""

import json
import re
import sys
from pathlib import Path

# Reached only through exported functions; their members are not declared.
OPAQUE = {"ClassFactory", "Omega"}
TEMPLATES = {"OpenMPArrayAccumulator<double>", "Se3<double>"}
HIDDEN_FROM_PYTHON = 8
# Size and alignment in a build without Eigen's alignment.
TYPES = {
    "Real": (8, 8),
    "Vector2r": (16, 8),
    "Vector3r": (24, 8),
    "Vector6r": (48, 8),
    "Vector2i": (8, 4),
    "Vector3i": (12, 4),
    "Matrix3r": (72, 8),
    "Matrix6r": (288, 8),
    "Quaternionr": (32, 8),
}


def declared(include: Path) -> set[str]:
    """Names of the classes in the headers."""
    sources = (path.read_text() for path in include.rglob("*.hpp"))
    return {
        name
        for text in sources
        for name in re.findall(r"^(?:class|struct) (\w+)\b(?!;)", text, re.M)
    }


def visible(member: dict) -> bool:
    """True for an attribute that Python can read."""
    return "attribute_flags" in member and not member["attribute_flags"] & HIDDEN_FROM_PYTHON


def vtable_bytes(vtable: dict) -> int:
    """Size of a table of virtual functions: two words before each group's slots."""
    return 8 * sum(len(group["slots"]) + 2 for group in vtable["groups"])


def reduce(full: dict, names: set[str]) -> dict:
    """The reduced table."""
    classes = {}
    for name in sorted((names | TEMPLATES) & full["classes"].keys() - OPAQUE):
        entry = full["classes"][name]
        members = [m for m in entry["members"] if not m["type"].endswith("&")]
        reduced = {"size": entry["size"], "align": entry["align"]}
        reduced["members"] = {m["name"]: m["offset"] for m in members}
        reduced["python"] = {m["name"]: m["type"] for m in members if visible(m)}
        vtable = entry.get("vtable")
        if vtable and vtable["verified"]:
            reduced["vtable"] = {"symbol": vtable["symbol"], "bytes": vtable_bytes(vtable)}
        classes[name] = reduced
    toolchain = dict(re.findall(r"(Boost|Python|Eigen) (\d+\.\d+)", full["build"]["toolchain"]))
    return {
        "version": full["build"]["version_string"],
        "boost": toolchain["Boost"],
        "python": toolchain["Python"],
        "types": TYPES,
        "classes": classes,
    }


def as_text(table: dict) -> str:
    """JSON with one line per class, so that changes are seen class by class."""
    head = {key: value for key, value in table.items() if key != "classes"}
    rows = ",\n".join(
        f'  "{name}": {json.dumps(entry)}' for name, entry in table["classes"].items()
    )
    return json.dumps(head)[:-1] + ',\n "classes": {\n' + rows + "\n }}\n"


if __name__ == "__main__":
    full = json.loads(Path(sys.argv[1]).read_text())
    sys.stdout.write(as_text(reduce(full, declared(Path(__file__).parent / "include"))))
