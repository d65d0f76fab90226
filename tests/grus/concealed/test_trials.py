"""The trials of validation/concealed: seals bind, recordings are readable and hold no hint."""

import json
import sys
from pathlib import Path

import pytest
from grus.recording import read

FOLDER = Path(__file__).resolve().parents[3] / "validation" / "concealed"
TRIALS = FOLDER / "trials"
RECORDINGS = sorted(TRIALS.glob("*/*/recording.csv"))

sys.path.insert(0, str(FOLDER))
from seal import seal, verify  # noqa: E402


def sealed() -> tuple[dict, dict]:
    return (json.loads((TRIALS / name).read_text()) for name in ("seals.json", "answers.json"))


def test_a_seal_tells_any_change_of_the_answer():
    answer = {"effects": [], "seed": 3}
    seals = {"101": seal("salt", answer)}
    assert verify(seals, {"101": {"salt": "salt", "answer": answer}}) == []
    assert verify(seals, {"101": {"salt": "salt", "answer": {**answer, "seed": 4}}}) == ["101"]
    assert verify(seals, {"101": {"salt": "other", "answer": answer}}) == ["101"]
    assert verify(seals, {}) == ["101"]


def test_answers_are_those_that_were_sealed():
    assert verify(*sealed()) == []


def test_every_sealed_recording_has_a_seal_and_the_reverse():
    seals, _ = sealed()
    assert sorted(seals) == sorted(path.name for path in TRIALS.glob("sealed/*"))


@pytest.mark.parametrize("path", RECORDINGS, ids=lambda path: path.parent.name)
def test_a_recording_is_read_and_holds_no_hint(path):
    record = read(path)
    assert 40 <= len(record) <= 600
    assert not any(key.startswith("comment") for key in record.meta)
    assert {file.name for file in path.parent.iterdir()} <= {"recording.csv", "program.toml"}
