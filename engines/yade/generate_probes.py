"""Write the load guard's table: what Python can see of YADE's objects, and the sizes of its vtables.

    generate_probes.py layout/VERSION-ARCHITECTURE.json > layout_probes.hpp
"""

import json
import sys
from collections.abc import Iterator
from pathlib import Path

# Types that probe.hpp has samples of; members of other types have probed neighbours.
PROBED = {"bool", "int", "unsigned", "long", "double", "std::string", "std::vector<int>"}
PROBED |= {"Vector3r", "Vector3i", "Matrix3r", "Quaternionr"}
PROBED |= {
    f"boost::shared_ptr<{k}>" for k in ("Bound", "IGeom", "IPhys", "Material", "Shape", "State")
}
# Python cannot make or show the first two; YADE checks or replaces what is set in the others.
EXCLUDED = {"BodyContainer", "EnergyTracker", "Cell.homoDeform", "Cell.prevHSize"}


def probes(table: dict) -> Iterator[str]:
    """One initialiser per member."""
    for name, entry in table["classes"].items():
        for member, kind in entry["python"].items():
            if kind not in PROBED or EXCLUDED & {name, f"{name}.{member}"}:
                continue
            place = f'{entry["members"][member]}, {entry["size"]}'
            yield f'    {{"{name}", "{member}", {place}, sizeof({kind}), &agrees<{kind}>}},'


def vtables(table: dict) -> Iterator[str]:
    """One initialiser per vtable that YADE exports."""
    for name, entry in table["classes"].items():
        if "vtable" in entry:
            yield f'    {{"{name}", "{entry["vtable"]["symbol"]}", {entry["vtable"]["bytes"]}}},'


if __name__ == "__main__":
    layout = json.loads(Path(sys.argv[1]).read_text())
    print("#pragma once", "", "namespace yade::sdk {", "", sep="\n")
    print(f'constexpr const char* layoutVersion = "{layout["version"]}";')
    print(f'constexpr const char* layoutBoost = "{layout["boost"]}";')
    print(f'constexpr const char* layoutPython = "{layout["python"]}";')
    print("", "const std::vector<Probe> layoutProbes = {", *probes(layout), "};", sep="\n")
    print(
        "", "const std::vector<Vtable> layoutVtables = {", *vtables(layout), "};", "", "}", sep="\n"
    )
