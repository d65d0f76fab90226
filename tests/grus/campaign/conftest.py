import pytest
from campaigns import PLANE, SEEDS, Client, disturbed_runs

import grus  # noqa: F401  loads YADE
from grus.campaign import Outcome, Run, Store, campaign
from grus.card import Card


@pytest.fixture(scope="session")
def card() -> Card:
    return Card.from_file(PLANE)


@pytest.fixture(scope="session")
def runs() -> list[Run]:
    return disturbed_runs()


@pytest.fixture(scope="session")
def whole(tmp_path_factory, runs) -> Store:
    """The store of a campaign that nothing disturbed."""
    store = Store(tmp_path_factory.mktemp("whole"))
    outcomes = campaign(runs, store, jobs=2)
    assert [outcome.failed for outcome in outcomes.values()] == [None] * SEEDS
    return store


@pytest.fixture(scope="session")
def expected(whole, runs) -> dict[str, Outcome]:
    return {run.key: whole.find(run.key) for run in runs}


@pytest.fixture
def client():
    """Starts campaigns, and ends those that a failed test leaves."""
    started = []

    def start(*arguments, **options) -> Client:
        started.append(Client(*arguments, **options))
        return started[-1]

    yield start
    for one in started:
        if one.process.poll() is None:
            one.process.kill()
            one.process.wait()
