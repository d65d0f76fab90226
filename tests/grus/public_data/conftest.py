"""A store of its own for each test, and the real files where they are at hand."""

from pathlib import Path

import pytest

from grus.public_data.store import ENVIRONMENT

SHARED = Path(__file__).resolve().parents[4] / "shared" / "data"


@pytest.fixture(autouse=True)
def store(tmp_path, monkeypatch):
    """An empty store."""
    monkeypatch.setenv(ENVIRONMENT, str(tmp_path / "store"))
    return tmp_path / "store"


@pytest.fixture
def shared():
    """Folder of the real files, which are not part of the repository."""
    if not SHARED.is_dir():
        pytest.skip(f"the public recordings are not at hand: no folder {SHARED}")
    return SHARED
