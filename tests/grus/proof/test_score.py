"""How verdicts are counted."""

import hashlib
import json

import pytest

from grus.errors import GrusError
from grus.proof import score, summary, write_report
from grus.proof.trials import answers, trials


def answer(grade: str, *effects: str, ratio: float = 5.0, tolerated: tuple = ()) -> dict:
    return {
        "grade": grade,
        "generator": "made",
        "tolerated": list(tolerated),
        "effects": [
            {"name": e, "in_library": e != "pore_water", "ratio_beyond_calibration": ratio}
            for e in effects
        ],
    }


def verdict(kind: str, *named: str, left_out: tuple = (), **probability: float) -> dict:
    errors = [{"left_out": {"rmse_strain": e}} for e in left_out]
    return {
        "verdict": kind,
        "mechanisms": [{"name": name} for name in named],
        "probability": probability,
        "before": errors[0] if errors else None,
        "after": errors[1] if errors else None,
    }


def test_each_kind_of_trial_is_counted_by_its_own_rule():
    truth = {
        "1": answer("single", "bond_ageing"),
        "2": answer("single", "bond_ageing"),
        "3": answer("single", "bond_ageing", ratio=1.0),
        "4": answer("pair", "bond_ageing", "wall_friction"),
        "5": answer("none"),
        "6": answer("none"),
        "7": answer("outside", "pore_water"),
        "8": answer("weak", "bond_ageing"),
        "9": answer("single", "bond_ageing", tolerated=("instrument_drift",)),
    }
    said = {
        "1": verdict("named", "bond_ageing", left_out=(4e-4, 1e-4)),
        "2": verdict("named", "bond_ageing", "wall_friction"),
        "3": verdict("nothing"),
        "4": verdict("named", "wall_friction", "bond_ageing", left_out=(4e-4, 2e-4)),
        "5": verdict("nothing"),
        "6": verdict("cannot_tell", "bond_ageing"),
        "7": verdict("named", "bond_ageing"),
        "8": verdict("nothing"),
        "9": verdict("named", "bond_ageing", "instrument_drift", left_out=(4e-4, 1e-4)),
    }
    found = score(truth, said)
    assert (found.named.good, found.named.all) == (2, 3)
    assert (found.pairs.good, found.pairs.all) == (1, 1)
    assert (found.quiet.good, found.quiet.all) == (2, 2)
    assert (found.unknown.good, found.unknown.all) == (0, 1)
    assert (found.weak.good, found.weak.all) == (1, 1)
    assert (found.improved.good, found.improved.all) == (2, 3)
    assert found.confusion["none"] == {"nothing": 1, "cannot_tell": 1}
    assert found.confusion["pore_water"] == {"bond_ageing": 1}


def test_probabilities_are_held_against_the_truth():
    truth = {"1": answer("single", "bond_ageing"), "2": answer("none")}
    said = {
        "1": verdict("named", "bond_ageing", bond_ageing=0.9, wall_friction=0.1, nothing=0.1),
        "2": verdict("nothing", bond_ageing=0.1, wall_friction=0.0, nothing=0.9),
    }
    found = score(truth, said)
    assert found.brier == pytest.approx((0.01 + 0.01 + 0.01 + 0.0) / 4)
    assert [b["number"] for b in found.reliability] == [1, 2, 1]


def test_a_recording_that_could_not_be_judged_is_no_success():
    truth = {"1": answer("outside", "pore_water")}
    found = score(truth, {"1": verdict("cannot_tell") | {"error": "no runs"}})
    assert found.unknown.good == 0


def test_report_and_summary(tmp_path):
    truth = {"1": answer("single", "bond_ageing"), "2": answer("none")}
    said = {"1": verdict("named", "bond_ageing", bond_ageing=0.9), "2": verdict("nothing")}
    found = score(truth, said)
    for name in write_report(found, tmp_path)[1:]:
        assert (tmp_path / name).stat().st_size > 0
    assert "1 of   1" in summary(found)


def sealed(folder, text: dict, salt: str = "s") -> None:
    (folder / "sealed" / "101").mkdir(parents=True)
    (folder / "sealed" / "101" / "recording.csv").write_text("time [h]\n")
    body = json.dumps(text, sort_keys=True, separators=(",", ":"))
    hashed = hashlib.sha256((salt + body).encode()).hexdigest()
    (folder / "seals.json").write_text(json.dumps({"101": hashed}))
    (folder / "answers.json").write_text(json.dumps({"101": {"salt": salt, "answer": text}}))


def test_answers_are_those_that_were_sealed(tmp_path):
    sealed(tmp_path, {"grade": "none"})
    assert answers(tmp_path, "all") == {"101": {"grade": "none"}}
    changed = json.loads((tmp_path / "answers.json").read_text())
    changed["101"]["answer"]["grade"] = "single"
    (tmp_path / "answers.json").write_text(json.dumps(changed))
    with pytest.raises(GrusError, match="101: not the answer that was sealed"):
        answers(tmp_path, "all")


def test_trials_of_a_set(tmp_path):
    sealed(tmp_path, {"grade": "none"})
    assert [t.name for t in trials(tmp_path, "all")] == ["101"]
    with pytest.raises(GrusError, match="allowed: all, quick, development"):
        trials(tmp_path, "every")
    with pytest.raises(GrusError, match="no trials"):
        trials(tmp_path, "development")
