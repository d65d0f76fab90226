"""YADE keeps one scene: every test begins with an empty one."""

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))


@pytest.fixture(autouse=True)
def empty_scene():
    import grus  # noqa: F401  loads YADE
    from yade import O

    O.reset()
    yield
    O.reset()
