"""What is simulated, and its key."""

import pytest

from grus.campaign import Run
from grus.errors import GrusError


def test_key_follows_what_decides_the_outcome(card):
    key = Run("crush", card).key
    assert Run("crush", card.with_overrides({"name": "another name"})).key == key
    changes = [
        Run("crush", card, grain=1),
        Run("crush", card.with_overrides({"seed": 77})),
        Run("crush", card.with_overrides({"bond.tensile_strength": "1.1 MPa"})),
        Run("oedometer", card),
        Run("recording", card),
    ]
    assert len({key, *(run.key for run in changes)}) == 6


@pytest.mark.parametrize(
    "arguments, message",
    [
        ({"kind": "triaxial"}, "kind = 'triaxial'; allowed: 'crush', 'oedometer', 'recording'"),
        ({"kind": "crush", "grain": -1}, "grain = -1"),
        ({"kind": "oedometer", "grain": 1}, "grain = 1"),
    ],
)
def test_impossible_runs_are_refused(card, arguments, message):
    with pytest.raises(GrusError, match=message):
        Run(card=card, **arguments)


def test_oedometer_needs_its_tables(card):
    with pytest.raises(GrusError, match="oedometer is missing"):
        Run("oedometer", card.with_overrides({"oedometer": None}))
