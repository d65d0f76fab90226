"""``import grus`` finds YADE, stays quiet and makes the classes YADE's own."""

import os
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest

from grus.host import locate
from grus.host.load import SUPPORTED

ROOT = Path(__file__).parents[2]


def run(command: list[str], **variables: str) -> subprocess.CompletedProcess:
    environment = {k: v for k, v in os.environ.items() if k != "YADE_PREFIX"}
    environment |= {"PYTHONPATH": str(ROOT / "pkg"), **variables}
    return subprocess.run(command, capture_output=True, text=True, env=environment)


def python(script: str, **variables: str) -> subprocess.CompletedProcess:
    return run([sys.executable, "-c", script], **variables)


def test_import_prints_nothing():
    done = python("import grus")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def test_classes_are_yades_classes():
    done = python(
        """
import grus, yade, yade.wrapper
from yade import *
from yade.wrapper import BondMat as same
assert grus.BondMat is yade.BondMat is yade.wrapper.BondMat is BondMat is same
assert grus.__version__ == "0.2.0"
assert O.isChildClassOf("BondMat", "FrictMat")
assert BondMat().dispHierarchy() == ["BondMat", "FrictMat", "ElastMat", "Material"]
from yade import system
assert "BondMat" in system.childClasses("Material")
"""
    )
    assert done.returncode == 0, done.stderr


def test_loading_again_changes_nothing():
    done = python(
        """
import grus
first = grus.BondMat
assert grus.load()["BondMat"] is grus.load()["BondMat"] is first
"""
    )
    assert done.returncode == 0, done.stderr


def test_no_home_folder_is_needed():
    done = subprocess.run(
        [sys.executable, "-c", "import grus"],
        capture_output=True,
        text=True,
        env={"PATH": os.defpath, "PYTHONPATH": str(ROOT / "pkg")},
    )
    assert done.returncode == 0, done.stderr


def test_missing_yade_is_one_line(tmp_path):
    done = python("import grus", YADE_PREFIX=str(tmp_path))
    last = done.stderr.splitlines()[-1]
    assert done.returncode == 1 and last.startswith("ImportError: grus needs YADE")
    assert str(tmp_path) in last and "YADE_PREFIX" in last


@pytest.mark.parametrize(
    "names", [["yade-longdouble", "yade-double", "yade-mpfr150"], ["yade-2030", "yade"]]
)
def test_double_build_comes_first(tmp_path, names):
    libraries = tmp_path / "lib" / sysconfig.get_config_var("MULTIARCH")
    for name in names:
        package = libraries / name / "py" / "yade"
        package.mkdir(parents=True)
        (package / "__init__.py").touch()
    best = "yade-double" if "yade-double" in names else "yade"
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("YADE_PREFIX", str(tmp_path))
        assert locate.yade_folder() == libraries / best / "py"


def test_the_installed_version_is_that_of_the_running_yade():
    import yade

    assert locate.installed_version() == yade.config.version


def test_missing_module_is_one_line(tmp_path):
    unbuilt = shutil.ignore_patterns("*.so", "__pycache__")
    shutil.copytree(ROOT / "pkg" / "grus", tmp_path / "grus", ignore=unbuilt)
    done = python("import grus", PYTHONPATH=str(tmp_path))
    assert (
        done.stderr.splitlines()[-1]
        == "ImportError: grus is not built: its module _engines is missing (run cmake)"
    )


def test_engines_of_another_host_are_refused_in_one_line(tmp_path):
    """As the loader meets them: linked against a Boost that is not here."""
    shutil.copytree(ROOT / "pkg" / "grus", tmp_path / "grus", ignore=shutil.ignore_patterns("*.so"))
    boost, empty = tmp_path / "libboost_python399.so.1.99.0", ["g++", "-shared", "-x", "c++"]
    subprocess.run([*empty, "/dev/null", f"-Wl,-soname,{boost.name}", "-o", boost], check=True)
    module = ["-Wl,--no-as-needed", "-x", "none", boost, "-o", tmp_path / "grus" / "_engines.so"]
    subprocess.run([*empty, "/dev/null", *module], check=True)
    boost.unlink()
    done = python(
        """
try:
    import grus
except ImportError as refusal:
    print(refusal)
import yade
yade.O.step()
print(yade.O.iter)
""",
        PYTHONPATH=str(tmp_path),
    )
    refusal, steps = done.stdout.splitlines()
    assert refusal.startswith(f"grus cannot use YADE {locate.installed_version()}: {boost.name}")
    assert refusal.endswith(f"; supported: {SUPPORTED}") and steps == "1", done.stderr


@pytest.mark.parametrize("threads", [1, 2])
def test_bare_names_in_a_yade_script(tmp_path, threads):
    script = tmp_path / "script.py"
    script.write_text(
        """
import grus
O.materials.append(BondMat(label="rock", density=2600))
O.bodies.append([utils.sphere((x, 0, 0), 0.5, material="rock", color=(1, 1, 1)) for x in (0, 0.99)])
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()]),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom()],
        [Ip2_BondMat_BondMat_BondPhys()],
        [Law2_ScGeom_BondPhys_Bonded()],
    ),
    NewtonIntegrator(),
]
O.dt = 1e-6
O.run(10, True)
assert isinstance(O.interactions[0, 1].phys, BondPhys)
assert isinstance(O.bodies[0].state, BondState)
print("done", O.iter)
"""
    )
    done = run(["yade", "-n", "-x", f"-j{threads}", str(script)])
    assert done.returncode == 0 and "done 10" in done.stdout, done.stdout + done.stderr


def test_positional_and_unknown_arguments_are_refused():
    done = python(
        """
import grus
for wrong in (lambda: grus.BondMat(3), lambda: grus.BondMat(density=1, colour=3)):
    try:
        wrong()
    except Exception as refusal:
        print(type(refusal).__name__, refusal)
"""
    )
    assert done.stdout.splitlines() == [
        "RuntimeError BondMat: takes keyword arguments only, 1 positional given",
        "AttributeError No such attribute: colour.",
    ]
