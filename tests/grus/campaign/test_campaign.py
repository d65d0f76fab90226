"""Campaigns that nothing disturbs: what is run, what is not, what is told."""

import os
import time

import numpy as np
import pytest
from campaigns import SEEDS, WARM, assert_same, below, until

from grus.campaign import Run, Store, campaign, cluster, workers
from grus.crushing import crush
from grus.errors import GrusError


def test_outcome_is_that_of_the_test_itself(expected, runs):
    for run in runs[:2]:
        result, outcome = crush(run.card), expected[run.key]
        assert outcome.figures["peak.strength"] == result.strength
        assert outcome.figures["bonds.broken"] == result.tension_breaks + result.shear_breaks
        np.testing.assert_array_equal(outcome.record["force"], result.record["force"])
        assert outcome.card == run.card.to_dict()
        assert set(outcome.versions) == {"grus", "yade", "python"}
        assert outcome.seconds > 0


def test_nothing_is_run_twice(whole, expected, runs):
    calls, lines = [], []
    again = campaign(runs, whole, progress=lambda *now: calls.append(now), tell=lines.append)
    assert calls == [(SEEDS, SEEDS)] and lines == []
    assert list(again) == [run.key for run in runs]
    assert_same(again, expected)


def test_only_what_is_missing_is_run(whole, expected, runs, tmp_path):
    store = Store(tmp_path).make()
    store.save(expected[runs[0].key])
    calls, lines, ends = [], [], []
    found = campaign(
        [runs[1], runs[0], runs[1]],
        store,
        1,
        progress=lambda *now: calls.append(now),
        ended=ends.append,
        tell=lines.append,
    )
    assert calls == [(1, 2), (2, 2)]
    assert [one.key for one in ends] == [runs[0].key, runs[1].key], "what is there comes first"
    assert ends[1] is found[runs[1].key]
    assert list(found) == [runs[1].key, runs[0].key]
    assert "http://" in lines[0]
    assert_same(found, {run.key: expected[run.key] for run in runs[:2]})
    assert not list(store.runs.glob(".*"))


def test_a_damaged_file_is_computed_anew(expected, runs, tmp_path):
    store = Store(tmp_path).make()
    store.save(expected[runs[0].key])
    path = store.path(runs[0].key)
    content = bytearray(path.read_bytes())
    content[len(content) // 2] ^= 1
    path.write_bytes(content)
    lines = []
    found = campaign(runs[:1], store, 1, tell=lines.append)
    assert str(path) in lines[0] and "computed anew" in lines[0]
    assert_same(found, {runs[0].key: expected[runs[0].key]})
    assert store.find(runs[0].key) is not None


def test_failures_do_not_stop_the_rest(card, runs, expected, tmp_path):
    impossible = Run("oedometer", card.with_overrides({"specimen.void_ratio": 3}))
    # The platens would take hours.
    endless = Run("crush", card.with_overrides({"crush.speed": "1e-9 m/s"}))
    wanted = [endless, impossible, runs[0]]
    store = Store(tmp_path)
    found = campaign(wanted, store, 1, time_limit=8)
    assert found[endless.key].failed == "not over within 8 s"
    assert not found[endless.key].final
    assert "specimen" in found[impossible.key].failed and found[impossible.key].final
    assert found[impossible.key].record is None
    assert_same({runs[0].key: found[runs[0].key]}, {runs[0].key: expected[runs[0].key]})
    calls = []
    campaign([impossible, runs[0]], store, progress=lambda *now: calls.append(now))
    assert calls == [(2, 2)], "what a card makes impossible is not tried again"


def test_memory_limit_is_that_of_the_process(runs, tmp_path):
    found = campaign(runs[:1], Store(tmp_path), 1, memory_limit=50_000_000)
    failed = found[runs[0].key]
    assert failed.failed.startswith("ended ") and failed.failed.endswith("the second attempt too")
    assert failed.log


def test_nothing_is_begun_after_the_deadline(expected, runs, whole, tmp_path):
    store = Store(tmp_path).make()
    store.save(expected[runs[1].key])
    found = campaign(runs, store, 1, deadline=time.monotonic() - 1)
    assert list(found) == [runs[1].key]
    assert [path.stem for path in store.runs.iterdir()] == [runs[1].key]


def test_workers_load_yade_before_the_first_run():
    with workers(1):
        until(lambda: below(os.getpid(), WARM))
    until(lambda: not below(os.getpid(), WARM))


def test_workers_may_serve_several_campaigns(runs, expected, tmp_path):
    store = Store(tmp_path)
    with workers(1) as client:
        first = campaign(runs[:1], store, client=client)
        assert_same(first | campaign(runs[1:], store, client=client), expected)


def test_recording_is_that_of_the_oedometer(card, tmp_path):
    gentle = card.with_overrides({"oedometer.stages": ["load to 20 kPa"]})
    both = [Run(kind, gentle) for kind in ("oedometer", "recording")]
    whole, brief = campaign(both, Store(tmp_path), 1).values()
    assert set(brief.figures) < set(whole.figures)
    assert brief.figures.items() <= whole.figures.items()
    for name in whole.record.channels:
        np.testing.assert_array_equal(brief.record[name], whole.record[name])


def test_specimens_are_shared(card, tmp_path):
    gentle = card.with_overrides({"oedometer.stages": ["load to 20 kPa"]})
    wanted = [
        Run("oedometer", gentle.with_overrides({"oedometer.wall_friction": friction}))
        for friction in (0, 0.3)
    ]
    store = Store(tmp_path)
    found = campaign(wanted, store, 2)
    assert [found[run.key].failed for run in wanted] == [None, None]
    assert len(list(store.specimens.glob("specimen-*.h5"))) == 1
    assert list((tmp_path / "work").iterdir()) == []
    for outcome in found.values():
        assert {"axial_stress", "axial_strain", "lateral_stress", "ae_events"} <= set(
            outcome.record.channels
        )
        assert outcome.record["axial_stress"].max() > 19e3
        assert {"bonds.broken", "energy.error", "void_ratio.final"} <= set(outcome.figures)


@pytest.mark.parametrize("limits", [{"jobs": -1}, {"time_limit": 0}, {"memory_limit": -5}])
def test_impossible_limits_are_refused(runs, tmp_path, limits):
    name, value = next(iter(limits.items()))
    with pytest.raises(GrusError, match=f"{name} = {value}; allowed"):
        campaign(runs, Store(tmp_path / "store"), **limits)
    assert not (tmp_path / "store").exists()


def test_no_scheduler_is_told(runs, tmp_path, monkeypatch):
    monkeypatch.setattr(cluster, "CONNECT", 1.0)
    with pytest.raises(GrusError, match="tcp://127.0.0.1:1.*allowed"):
        campaign(runs, Store(tmp_path), scheduler="tcp://127.0.0.1:1")
