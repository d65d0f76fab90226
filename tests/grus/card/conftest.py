import copy
from pathlib import Path

import pytest

from grus.card import Card, CardError

MODELS = Path(__file__).resolve().parents[3] / "models"


@pytest.fixture(scope="session")
def models():
    return MODELS


@pytest.fixture(scope="session")
def _written():
    return Card.from_file(MODELS / "montesinho.toml").written


@pytest.fixture
def written(_written):
    """The tables of a good plane card, free to be changed."""
    return copy.deepcopy(_written)


@pytest.fixture(scope="session")
def plane():
    return Card.from_file(MODELS / "montesinho.toml")


@pytest.fixture(scope="session")
def solid():
    return Card.from_file(MODELS / "montesinho-3d.toml")


@pytest.fixture(scope="session")
def refusal():
    """Calls a function that must refuse a card, and returns the one line that says why."""

    def refused(function, *arguments):
        with pytest.raises(CardError) as caught:
            function(*arguments)
        message = str(caught.value)
        assert message and len(message.splitlines()) == 1 and message.isprintable()
        return message

    return refused
