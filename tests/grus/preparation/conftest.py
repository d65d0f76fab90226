from pathlib import Path

import pytest

import grus  # first, since it loads YADE
from grus.card import Card
from grus.preparation import prepare

MODELS = Path(__file__).resolve().parents[3] / "models"
SPACE = {
    "width": "29 mm",
    "depth": "29 mm",
    "height": "29 mm",
    "void_ratio": 1.0,
    "minimum_diameter": "11 mm",
    "maximum_diameter": "14 mm",
    "rms_diameter": "12.4 mm",
}


@pytest.fixture(scope="session")
def plane():
    return Card.from_file(MODELS / "quick.toml").with_overrides({"element.radius": "0.9 mm"})


@pytest.fixture(scope="session")
def solid():
    return Card.from_file(MODELS / "montesinho-3d.toml").with_overrides(
        {"specimen": SPACE, "element.radius": "1.3 mm"}
    )


@pytest.fixture(scope="session")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("specimens")


@pytest.fixture(scope="session")
def prepared_plane(plane, folder):
    return prepare(plane, folder)


@pytest.fixture(scope="session")
def prepared_solid(solid, folder):
    return prepare(solid, folder)
