from pathlib import Path

import pytest

import grus  # noqa: F401  loads YADE
from grus.card import Card
from grus.oedometer import oedometer

CARDS = Path(__file__).resolve().parents[2] / "cards"


@pytest.fixture(scope="session")
def plane() -> Card:
    return Card.from_file(CARDS / "plane.toml")


@pytest.fixture(scope="session")
def space() -> Card:
    return Card.from_file(CARDS / "space.toml")


@pytest.fixture(scope="session")
def specimens(tmp_path_factory) -> Path:
    """Where all tests find the prepared specimens."""
    return tmp_path_factory.mktemp("specimens")


@pytest.fixture(scope="session")
def plane_folder(tmp_path_factory) -> Path:
    return tmp_path_factory.mktemp("plane")


@pytest.fixture(scope="session")
def plane_result(plane, plane_folder, specimens):
    return oedometer(plane, plane_folder, specimens=specimens)


@pytest.fixture(scope="session")
def space_result(space, tmp_path_factory, specimens):
    return oedometer(space, tmp_path_factory.mktemp("space"), specimens=specimens)


@pytest.fixture(params=["plane", "space"])
def result(request):
    return request.getfixturevalue(f"{request.param}_result")


@pytest.fixture
def gentle(plane) -> Card:
    """The plane card with loads that hardly break anything."""
    stages = ["load to 30 kPa", "load to 60 kPa", "unload to 20 kPa"]
    return plane.with_overrides({"oedometer.stages": stages})
