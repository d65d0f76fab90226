import os
from pathlib import Path

import numpy as np
import pytest


def weibull_draw(ids, n, modulus, sigma0=1.0):
    """n Weibull strengths of the stream named by ``ids``."""
    stream = np.random.SeedSequence(entropy=2015, spawn_key=tuple(ids))
    uniform = np.random.Generator(np.random.PCG64(stream)).random(n)
    return sigma0 * (-np.log1p(-uniform)) ** (1.0 / modulus)


@pytest.fixture(name="draw")
def draw_fixture():
    return weibull_draw


@pytest.fixture
def static_fatigue():
    """Folder of the published samples; $GRUS_SHARED, or ``shared`` beside the repository."""
    beside = Path(__file__).resolve().parents[3].parent / "shared"
    folder = Path(os.environ.get("GRUS_SHARED", beside)) / "data" / "static-fatigue"
    if not folder.is_dir():
        pytest.skip("published samples not found: set GRUS_SHARED to the folder that holds data/")
    return folder
