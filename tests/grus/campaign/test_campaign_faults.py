"""Campaigns that are disturbed: nothing that was finished is lost, and what is found at last is what is found undisturbed."""

import os
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path

import pytest
from campaigns import SEEDS, assert_same, until

from grus.campaign import Store, campaign


def outcomes(store: Store) -> dict:
    return {outcome.key: outcome for outcome in store.outcomes()}


def test_simulation_is_killed(client, tmp_path, expected):
    disturbed = client(tmp_path)
    until(lambda: disturbed.simulations())[0].kill()
    out, errors = disturbed.end()
    assert "failed: []" in out and errors == ""
    assert_same(outcomes(disturbed.store), expected)


def test_simulation_is_killed_twice(client, tmp_path, expected, runs):
    disturbed = client(tmp_path)
    victim = until(lambda: disturbed.simulations())[0]
    victim.kill()
    until(lambda: [one for one in disturbed.simulations() if one.pid != victim.pid])[0].kill()
    out, _ = disturbed.end()
    assert "failed: ['ended by SIGKILL; the second attempt too']" in out
    found = outcomes(disturbed.store)
    assert not found.pop(runs[0].key).final
    assert_same(found, {key: one for key, one in expected.items() if key != runs[0].key})
    # The next campaign tries again.
    assert_same(campaign(runs, disturbed.store, 1), expected)


def test_process_that_simulations_are_forked_from_is_killed(client, tmp_path, expected):
    disturbed = client(tmp_path)
    victim = until(lambda: disturbed.simulations())[0]
    victim.parent().kill()
    until(lambda: not victim.is_running())
    out, _ = disturbed.end()
    assert "failed: []" in out
    assert_same(outcomes(disturbed.store), expected)


def test_worker_is_killed(client, tmp_path, expected):
    disturbed = client(tmp_path)
    victim = until(lambda: disturbed.simulations())[0]
    victim.parent().parent().kill()
    until(lambda: not victim.is_running())  # no simulation outlives its worker
    out, _ = disturbed.end()
    assert "failed: []" in out
    assert_same(outcomes(disturbed.store), expected)


def test_client_is_killed(client, tmp_path, expected, runs):
    disturbed = client(tmp_path)
    until(lambda: len(list(disturbed.store.runs.glob("[0-9a-f]*"))) == 1)
    children = disturbed.children("")
    disturbed.process.kill()
    for child in children:
        until(lambda: not child.is_running())
    finished = outcomes(disturbed.store)
    assert finished
    stamps = {key: disturbed.store.path(key).stat().st_mtime_ns for key in finished}
    assert_same(campaign(runs, disturbed.store, 2), expected)
    for key, stamp in stamps.items():
        assert disturbed.store.path(key).stat().st_mtime_ns == stamp
    assert not list(disturbed.store.runs.glob(".*"))


def test_interrupted_by_its_user(client, tmp_path, expected, runs):
    disturbed = client(tmp_path)
    until(lambda: len(list(disturbed.store.runs.glob("[0-9a-f]*"))) == 1)
    children = disturbed.children("")
    disturbed.interrupt()
    _, errors = disturbed.end()
    assert errors.splitlines()[-1] == "KeyboardInterrupt"
    for child in children:
        until(lambda: not child.is_running())
    assert 1 <= len(outcomes(disturbed.store)) < SEEDS
    assert_same(campaign(runs, disturbed.store, 2), expected)


def test_two_campaigns_share_a_store(client, tmp_path, expected):
    disturbed = [client(tmp_path) for _ in range(2)]
    for one in disturbed:
        out, errors = one.end()
        assert "failed: []" in out and errors == ""
    assert_same(outcomes(disturbed[0].store), expected)


def test_scheduler_is_killed(client, tmp_path, expected):
    store = tmp_path / "store"
    with scheduler(tmp_path) as (address, process):
        disturbed = client(store, scheduler=address)
        until(lambda: len(list(disturbed.store.runs.glob("[0-9a-f]*"))) == 1)
        process.kill()
        _, errors = disturbed.end()
    assert "GrusError" in errors.splitlines()[-1] and "start it again" in errors.splitlines()[-1]
    assert outcomes(disturbed.store)
    with scheduler(tmp_path) as (address, _):
        out, errors = client(store, scheduler=address).end()
    assert "failed: []" in out, errors
    assert_same(outcomes(disturbed.store), expected)


@contextmanager
def scheduler(folder: Path):
    """File and process of a scheduler with one worker."""
    file = folder / "scheduler.json"
    file.unlink(missing_ok=True)
    programs = {
        "dask_scheduler": ["--host", "127.0.0.1", "--port", "0", "--no-dashboard"],
        "dask_worker": ["--nthreads", "1", "--no-dashboard", "--local-directory", str(folder)],
    }
    started = [
        subprocess.Popen(
            [sys.executable, "-m", f"distributed.cli.{name}", "--scheduler-file", file, *options],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        for name, options in programs.items()
    ]
    try:
        until(file.exists)
        yield str(file), started[0]
    finally:
        for one in started:
            one.terminate()
            one.wait(30)


@pytest.fixture
def tiny(tmp_path):
    """A file system that outcomes do not fit on."""
    if os.geteuid() != 0:
        pytest.skip("only root can mount a file system of a given size")
    made = subprocess.run(
        ["mount", "-t", "tmpfs", "-o", "size=512k", "tmpfs", tmp_path], capture_output=True
    )
    if made.returncode:
        pytest.skip("mounting is not allowed here")
    yield tmp_path
    subprocess.run(["umount", tmp_path], check=True)


def test_disk_is_full(tiny, client, expected, runs):
    filler = tiny / "filler"
    store = Store(tiny / "store").make()
    store.save(expected[runs[0].key])
    with open(filler, "wb", buffering=0) as file:
        try:
            while file.write(b"\0" * 4096):
                pass
        except OSError:
            pass  # full
    disturbed = client(store.folder)
    _, errors = disturbed.end()
    assert "No space left on device" in errors.splitlines()[-1]
    assert set(outcomes(store)) == {runs[0].key}
    filler.unlink()
    assert_same(campaign(runs, store, 1), expected)
    assert not list(store.runs.glob(".*"))
