"""Diagnoses that need no DEM."""

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

from soil import CARD, STAGES, deformed, without_dem  # noqa: E402

from grus.card import Card  # noqa: E402
from grus.diagnosis import diagnose  # noqa: E402
from grus.diagnosis.base import Base  # noqa: E402
from grus.diagnosis.estimate import Culprit, Estimate  # noqa: E402
from grus.diagnosis.report import write_report  # noqa: E402
from grus.diagnosis.simulator import Test  # noqa: E402
from grus.diagnosis.verdict import Decision  # noqa: E402
from grus.recording import write  # noqa: E402


@pytest.fixture(scope="session")
def recording(tmp_path_factory):
    """File of a test in which bonds age, with noise."""
    card = Card.from_file(CARD).with_overrides({"oedometer.stages": STAGES})
    ageing = (("bond_ageing", (("reference_time", 5e3),)),)
    record = deformed(card, Test(Base(4), 77, ageing))
    noise = np.random.default_rng(5).normal(0, 5e-6, len(record))
    strain = record["axial_strain"] + noise
    path = tmp_path_factory.mktemp("recording") / "creep.csv"
    write(replace(record, channels=record.channels | {"axial_strain": strain}, segments=()), path)
    return path


@pytest.fixture(scope="session")
def named(recording, tmp_path_factory):
    """A diagnosis that has named the ageing of bonds and put it back."""
    with pytest.MonkeyPatch.context() as patch:
        without_dem(patch)
        return diagnose(recording, Card.from_file(CARD), tmp_path_factory.mktemp("store"))


@pytest.fixture(scope="session")
def nothing(named):
    """The same with another verdict, as are the two below."""
    decision = Decision("nothing", (), {"nothing": 0.93, "unknown": 0.02, "bond_ageing": 0.05})
    return replace(named, decision=decision, culprits=(), improvement=None)


@pytest.fixture(scope="session")
def cannot_tell(named):
    probability = {"bond_ageing": 0.6, "instrument_drift": 0.35, "nothing": 0.03, "unknown": 0.02}
    decision = Decision("cannot_tell", ("bond_ageing", "instrument_drift"), probability)
    rate = Estimate("strain_rate", 1e-9, 5e-10, 2e-9, "1/s")
    other = Culprit("instrument_drift", "Drift and offset of the instrument", 0.35, (rate,))
    return replace(
        named,
        decision=decision,
        culprits=(replace(named.culprits[0], probability=0.6), other),
        improvement=None,
        next_measurement="hold the highest stress 10 times as long",
    )


@pytest.fixture(scope="session")
def unknown(named):
    probability = {"unknown": 0.9, "bond_ageing": 0.2, "nothing": 0.0}
    decision = Decision("unknown", (), probability)
    return replace(named, decision=decision, culprits=(), improvement=None)


@pytest.fixture(scope="session")
def report(request, tmp_path_factory):
    """Folder with the report of a verdict, written once."""
    folders = {}

    def written(verdict):
        if verdict not in folders:
            folders[verdict] = tmp_path_factory.mktemp(verdict)
            write_report(request.getfixturevalue(verdict), folders[verdict])
        return folders[verdict]

    return written
