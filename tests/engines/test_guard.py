"""A YADE whose binary interface is not the described one is refused, and stays usable."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from grus.host.load import SUPPORTED
from grus.host.locate import installed_version

ROOT = Path(__file__).parents[2]
YADE = installed_version()
LAYOUT = ROOT / "engines" / "yade" / "layout" / f"{YADE}-amd64.json"
TABLE = json.loads(LAYOUT.read_text())

# The package without its __init__, which would load and register.
PRELUDE = f"""
import sys, types
package = types.ModuleType("grus")
package.__path__ = [{str(ROOT / "pkg" / "grus")!r}]
sys.modules["grus"] = package
from grus.host import load
yade = load.import_yade()
engines = load.import_engines(yade)
"""


def python(script: str) -> str:
    """Standard output of a script after the prelude, in an interpreter of its own."""
    environment = {k: v for k, v in os.environ.items() if k not in ("PYTHONPATH", "YADE_PREFIX")}
    run = subprocess.run(
        [sys.executable, "-c", PRELUDE + script], capture_output=True, text=True, env=environment
    )
    assert run.returncode == 0, run.stderr
    return run.stdout


def differences(expected: dict) -> list[str]:
    return json.loads(python(f"import json; print(json.dumps(engines.check({expected!r})))"))


def test_the_installed_yade_agrees():
    assert differences({}) == []


@pytest.mark.parametrize(
    "entry, offset",
    [
        ("Sphere.radius", 80),  # its place in a YADE without deformable elements
        ("FrictMat.frictionAngle", 88),
        ("Material.label", 32),
        ("State.inertia", 200),
        ("Body.shape", 56),
        ("Interaction.iterMadeReal", 104),
        ("FrictPhys.tangensOfFrictionAngle", 88),
        ("ScGeom.penetrationDepth", 152),
        ("PeriodicEngine.initRun", 137),
        ("PartialEngine.ids", 96),
        ("Scene.dt", 432),
        ("Cell.hSize", 664),
    ],
)
def test_a_member_elsewhere_is_found(entry, offset):
    assert differences({entry: offset}) == [f"{entry} is not at byte {offset}"]


@pytest.mark.parametrize(
    "entry, wanted, name",
    [("version", "2030.1", "YADE"), ("boost", "1.99", None), ("python", "3.99", None)],
)
def test_another_version_is_found(entry, wanted, name):
    assert differences({entry: wanted}) == [f"{name or entry} {TABLE[entry]} instead of {wanted}"]


def test_another_number_of_virtual_functions_is_found():
    size = TABLE["classes"]["LawFunctor"]["vtable"]["bytes"]
    text = f"virtual functions of LawFunctor take {size} bytes, not {size + 8}"
    assert differences({"LawFunctor": size + 8}) == [text]


def test_a_place_outside_the_object_is_refused():
    out = python(
        """
try:
    engines.check({"Sphere.radius": 104})
except KeyError as refusal:
    print(refusal)
"""
    )
    assert "Sphere.radius" in out


def test_the_table_covers_what_python_shows_of_the_declared_classes():
    classes = TABLE["classes"]
    shown = sum(len(entry["python"]) for entry in classes.values())
    expected = {f"{name}.{member}": 0 for name, c in classes.items() for member in c["python"]}
    found = python(
        f"""
probed = 0
for entry in {sorted(expected)!r}:
    try:
        probed += engines.check({{entry: 0}}) == [entry + " is not at byte 0"]
    except KeyError:
        pass
print(probed)
"""
    )
    assert int(found) >= 0.85 * shown


def test_refusal_is_one_line_and_registers_nothing():
    out = python(
        """
for expected in ({"version": "2030.1"}, {"Sphere.radius": 80}):
    try:
        load.load(expected)
    except ImportError as refusal:
        print(refusal)
assert not hasattr(yade.wrapper, "BondMat")
"""
    )
    assert out == (
        f"grus cannot use YADE {YADE}: YADE {YADE} instead of 2030.1; supported: {SUPPORTED}\n"
        f"grus cannot use YADE {YADE}: Sphere.radius is not at byte 80; supported: {SUPPORTED}\n"
    )


def test_the_table_is_that_of_a_supported_version():
    assert YADE in SUPPORTED
    assert all(path.name.split("-")[0] in SUPPORTED for path in LAYOUT.parent.glob("*.json"))


def test_many_differences_stay_one_line():
    wrong = {f"State.{name}": 8 for name in ("mass", "vel", "inertia", "angVel", "angMom")}
    out = python(
        f"""
try:
    load.load({wrong!r})
except ImportError as refusal:
    print(refusal)
"""
    )
    assert out.count("\n") == 1 and " and 2 more; supported" in out


def test_yade_runs_after_a_refusal():
    out = python(
        """
try:
    load.load({"Sphere.radius": 80})
except ImportError:
    pass
from yade import *
from yade import utils
O.bodies.append(utils.sphere((0, 0, 0), 1, color=(1, 1, 1)))
O.engines = [NewtonIntegrator(damping=0, gravity=(0, 0, -10))]
O.dt = 1e-3
O.run(100, True)
print(O.iter, O.bodies[0].state.vel[2])
"""
    )
    steps, velocity = out.split()
    assert int(steps) == 100 and float(velocity) == pytest.approx(-1.0, rel=1e-9)


def test_check_leaves_the_scene_alone():
    out = python(
        """
from yade import *
from yade import utils
O.bodies.append(utils.sphere((0, 0, 0), 1, color=(1, 1, 1)))
O.dt = 0.25
before = (len(O.bodies), len(O.materials), len(O.interactions), O.dt, O.iter, O.tags["id"])
assert engines.check({}) == []
print(before == (len(O.bodies), len(O.materials), len(O.interactions), O.dt, O.iter, O.tags["id"]))
"""
    )
    assert out == "True\n"


@pytest.mark.parametrize("entry", ["Sphere.colour", "Ball", "yade"])
def test_unknown_entries_are_refused(entry):
    out = python(
        f"""
try:
    engines.check({{{entry!r}: 0}})
except KeyError as refusal:
    print(refusal)
"""
    )
    assert entry in out and out.count("\n") == 1
