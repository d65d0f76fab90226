import pytest
from grus.verification import verify
from yade import O, utils  # after grus, which knows where YADE is


@pytest.fixture(scope="session")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("verification") / "new"


@pytest.fixture(scope="session")
def calls():
    """What `verify` told about its progress."""
    return []


@pytest.fixture(scope="session")
def scene():
    """Number of bodies and of steps of the caller's own scene, before and after `verify`."""
    return []


@pytest.fixture(scope="session")
def verification(folder, calls, scene):
    """The one run of all cases."""
    O.reset()
    O.bodies.append(utils.sphere((0, 0, 0), 1))
    scene.append((len(O.bodies), O.iter))
    found = verify(folder, lambda done, of: calls.append((done, of)))
    scene.append((len(O.bodies), O.iter))
    O.reset()
    return found
