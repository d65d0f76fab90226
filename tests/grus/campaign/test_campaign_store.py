"""Outcomes in a folder: what is read is what was written, or nothing."""

import dataclasses
import threading

import h5py
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from grus.campaign import Outcome, Store
from grus.record import Record


@pytest.fixture
def outcome() -> Outcome:
    force = np.array([0.0, 0.1, np.pi])
    record = Record({"closing": force / 3, "force": force}, {"closing": "m", "force": "N"})
    return Outcome("ab" * 32, "crush", {"name": "x", "seed": 3}, 2, record, {"peak.force": 0.1})


@pytest.fixture
def store(tmp_path) -> Store:
    return Store(tmp_path / "store").make()


def test_outcome_survives_its_file(store, outcome):
    store.save(outcome)
    found = store.find(outcome.key)
    assert dataclasses.replace(found, record=None) == dataclasses.replace(outcome, record=None)
    assert found.record.units == outcome.record.units
    for name in outcome.record.channels:
        np.testing.assert_array_equal(found.record[name], outcome.record[name])


def test_arrays_survive_their_file(store, outcome):
    arrays = {
        "after.mode": np.array([1, 2]),
        "after.broken": np.empty((0, 2), dtype=np.int64),
        "gap": np.array(np.pi),
        "ended": np.array("crushed é"),
        "names": np.array(["a", "bc"]),
    }
    store.save(dataclasses.replace(outcome, arrays=arrays))
    found = store.find(outcome.key).arrays
    assert set(found) == set(arrays)
    for name, values in arrays.items():
        np.testing.assert_array_equal(found[name], values)
        assert found[name].dtype == values.dtype and found[name].shape == values.shape


def test_failure_survives_its_file(store, outcome):
    failed = dataclasses.replace(
        outcome, record=None, figures={}, failed="ended by SIGKILL", log="é\n" * 50_000
    )
    store.save(failed)
    assert store.find(outcome.key) == failed
    assert not failed.final and dataclasses.replace(failed, refused=True).final


def test_other_tools_can_read_it(store, outcome):
    store.save(outcome)
    with h5py.File(store.path(outcome.key), "r") as file:
        assert file["figures/peak.force"][()] == 0.1
        assert file["record/force"].attrs["unit"] == "N"


def test_what_is_not_there_is_none(store, outcome):
    assert store.find(outcome.key) is None
    assert list(store.outcomes()) == []


@settings(
    max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(st.data())
def test_a_damaged_file_counts_as_none(store, outcome, data):
    store.save(outcome)
    path = store.path(outcome.key)
    content = bytearray(path.read_bytes())
    place = data.draw(st.integers(0, len(content) - 1))
    if data.draw(st.booleans()):
        content[place] ^= data.draw(st.integers(1, 255))
    else:
        del content[place:]
    path.write_bytes(bytes(content))
    lines = []
    assert store.find(outcome.key, lines.append) is None
    assert len(lines) == 1 and str(path) in lines[0] and "damaged" in lines[0]


def test_a_file_under_another_name_is_not_taken(store, outcome):
    store.save(outcome)
    store.path(outcome.key).rename(store.path("cd" * 32))
    assert store.find("cd" * 32) is None


def test_a_lock_is_held_by_one(store):
    order = []
    with store.lock("a"):
        other = threading.Thread(target=lambda: _take(store, order))
        other.start()
        other.join(0.2)
        order.append("first")
    other.join()
    assert order == ["first", "second"]


def _take(store: Store, order: list) -> None:
    with store.lock("a"):
        order.append("second")


def test_what_a_killed_process_left_is_removed(store, outcome):
    left = store.runs / f".partial-4242.{outcome.key}.h5"
    left.write_bytes(b"half")
    others = store.runs / ".partial-4242.another.h5"
    others.write_bytes(b"of a process that is still writing")
    with store.lock(outcome.key):
        assert not left.exists() and others.exists()


def test_a_specimen_without_its_checksum_is_not_taken(store):
    path = store.specimen("ef" * 32)
    path.write_bytes(b"grains")
    lines = []
    assert not store.check_specimen("ef" * 32, lines.append)
    assert len(lines) == 1 and not path.exists()
    path.write_bytes(b"grains")
    store.seal_specimen("ef" * 32)
    assert store.check_specimen("ef" * 32)
    path.write_bytes(b"grain")
    assert not store.check_specimen("ef" * 32)
