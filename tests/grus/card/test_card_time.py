"""Laboratory time in a card: stages that take time, wetting, [ageing] and [wetting]."""

import re

import pytest

from grus.card import Card
from grus.card.program import Program

TIMED = ["load to 100 kPa in 1 h", "hold for 24 h", "wet", "unload to 50 kPa"]
AGEING = {"exponent": 20, "reference_time": "100 s"}


@pytest.fixture
def staged(models):
    return Card.from_file(models / "quick.toml")


@pytest.mark.parametrize("extra", [" ", "\t"])
def test_stages_with_and_without_a_time(extra):
    words = [word.replace(" ", extra) for word in TIMED]
    stages = Program().read(words)
    assert [one.kind for one in stages] == ["load", "hold", "wet", "unload"]
    assert [one.stress for one in stages] == [100e3, None, None, 50e3]
    assert [one.duration for one in stages] == [3600, 86400, 60, None]
    assert Program().read([one.written() for one in stages]) == stages


def test_what_is_not_written_is_no_part_of_the_card(staged):
    """So that results of cards without these keys are found again."""
    plain = staged.to_dict()
    assert "ageing" not in plain and "wetting" not in plain
    assert "platens" not in plain["oedometer"]


@pytest.mark.parametrize(
    "overrides",
    [
        {"ageing": AGEING},
        {"ageing": {"law": "corrosion", "beta1": "1e-15 m/s", "beta2": 30, "threshold": "10 kPa"}},
        {"oedometer.stages": TIMED, "wetting": {"strength_factor": 0.8}},
        {"oedometer.stages": TIMED[:2], "wetting": {"strength_factor": 0.8, "time": "5 h"}},
        {"oedometer.platens": "top"},
    ],
)
def test_they_count_and_are_kept(staged, overrides):
    changed = staged.with_overrides(overrides)
    assert changed.content_hash() != staged.content_hash()
    assert Card.from_dict(changed.to_dict()) == changed


@pytest.mark.parametrize(
    "overrides, words",
    [
        ({"oedometer.stages": ["wet"]}, "nothing to wet yet"),
        ({"oedometer.stages": ["load to 1 kPa in"]}, "stage 1"),
        ({"oedometer.stages": ["load to 10 kPa in 3 m"]}, '"m" .meter. is not a time'),
        ({"oedometer.stages": TIMED}, "needs wetting.strength_factor"),
        ({"oedometer.stages": [*TIMED, "wet"], "wetting.strength_factor": 1}, '2 stages "wet"'),
        ({"wetting.strength_factor": 0}, "strength_factor = 0: out of bounds"),
        ({"wetting.strength_factor": 0.9}, 'wetting.time: is missing without a stage "wet"'),
        ({"wetting": {"strength_factor": 1, "time": "1 h"}}, "the stages take 0 s"),
        (
            {
                "oedometer.stages": TIMED,
                "wetting": {"strength_factor": 1, "time": "1 h"},
            },
            "wetting.time",
        ),
        ({"ageing": {}}, "ageing.exponent: is missing, law power needs it"),
        ({"ageing": AGEING | {"beta2": 3}}, "law power has no use for it"),
        ({"ageing": {"law": "corrosion", "beta2": 3}}, "ageing.beta1: is missing"),
        ({"ageing": AGEING | {"humidity": 1.1}}, "ageing.humidity = 1.1"),
        ({"ageing": AGEING | {"threshold": "1 N"}}, "a parallel bond needs a stress"),
        ({"ageing": AGEING, "oedometer": None}, "has no use without .oedometer."),
        ({"oedometer.platens": "bottom"}, '"both" or "top"'),
    ],
)
def test_refusals(staged, refusal, overrides, words):
    message = refusal(staged.with_overrides, overrides)
    assert re.search(words, message), message
