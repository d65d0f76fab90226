"""A test that is cut off goes on, and ends as if nothing had happened."""

import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from grus.errors import GrusError
from grus.oedometer import oedometer

RUN = """
import sys
import grus
from grus.card import Card
from grus.oedometer import oedometer

card, folder, specimens = sys.argv[1:]
oedometer(Card.from_file(card), folder, specimens=specimens, checkpoint=0.0)
"""


class Cut(Exception):
    """Raised in the middle of a test."""


def cut_at(share: float, error: type[BaseException] = Cut):
    """Progress that ends the run when this share of it is done."""

    def tell(done: float, line: str) -> None:
        if done >= share:
            raise error

    return tell


def assert_same(one, other) -> None:
    """Bit by bit, but for contacts' order of columns there is nothing to forgive."""
    for name, values in one.record.channels.items():
        np.testing.assert_array_equal(values, other.record[name], err_msg=name)
    for a, b in zip(one.stages, other.stages, strict=True):
        assert {n: v for n, v in vars(a).items() if n not in ("state", "contacts")} == {
            n: v for n, v in vars(b).items() if n not in ("state", "contacts")
        }
        for group in ("state", "contacts"):
            for name, values in vars(getattr(a, group)).items():
                np.testing.assert_array_equal(values, getattr(getattr(b, group), name), name)


def test_killed_at_any_moment(plane, plane_result, tmp_path, specimens):
    folder, wait = tmp_path / "out", random.uniform(0, 2)
    for _ in range(2):
        command = [sys.executable, "-c", RUN, plane.source, str(folder), str(specimens)]
        process = subprocess.Popen(command)
        scene = folder / "stages" / "scene.yade"
        while not scene.exists() and process.poll() is None:
            time.sleep(0.02)
        time.sleep(wait)
        process.send_signal(signal.SIGKILL)
        process.wait()
    print(f"killed {wait:.2f} s after the first checkpoint, twice")
    assert_same(plane_result, oedometer(plane, folder, specimens=specimens))


@pytest.mark.parametrize("share", [0.3, 0.6])
def test_interrupt_saves_the_middle_of_a_stage(plane, plane_result, tmp_path, specimens, share):
    with pytest.raises(KeyboardInterrupt, match=r"interrupted in stage \d, load to \d+ kPa, after"):
        oedometer(plane, tmp_path, cut_at(share, KeyboardInterrupt), specimens)
    assert (tmp_path / "stages" / "scene.yade").exists()
    assert_same(plane_result, oedometer(plane, tmp_path, specimens=specimens))


def test_stage_saved_but_its_scene_not(plane, plane_result, tmp_path, specimens):
    """As when a process is killed between the two."""
    with pytest.raises(KeyboardInterrupt):
        oedometer(plane, tmp_path, cut_at(0.6, KeyboardInterrupt), specimens)
    scene = tmp_path / "stages" / "scene.yade"
    middle = scene.read_bytes()
    oedometer(plane, tmp_path, specimens=specimens)
    scene.write_bytes(middle)
    for later in range(3, len(plane_result.stages)):
        (tmp_path / "stages" / f"stage-{later:03d}.h5").unlink()
    assert_same(plane_result, oedometer(plane, tmp_path, specimens=specimens))


def test_finished_test_is_not_run_again(plane, plane_folder, plane_result, specimens):
    before = {path: path.stat().st_mtime_ns for path in (plane_folder / "stages").iterdir()}
    assert_same(plane_result, oedometer(plane, plane_folder, cut_at(0.0), specimens))
    assert before == {path: path.stat().st_mtime_ns for path in (plane_folder / "stages").iterdir()}


def test_restart_runs_it_anew(gentle, tmp_path, specimens):
    first = oedometer(gentle, tmp_path, specimens=specimens)
    with pytest.raises(Cut):
        oedometer(gentle, tmp_path, cut_at(0.01), specimens, restart=True)
    assert not (tmp_path / "stages" / "stage-003.h5").exists()
    assert_same(first, oedometer(gentle, tmp_path, specimens=specimens))


@pytest.mark.parametrize("restart", [False, True])
def test_folder_of_another_card_is_refused(plane, plane_folder, plane_result, specimens, restart):
    other = plane.with_overrides({"oedometer.speed": "0.01 m/s"})
    with pytest.raises(GrusError, match="another card"):
        oedometer(other, plane_folder, specimens=specimens, restart=restart)
    assert (plane_folder / "stages" / "stage-003.h5").exists()


@pytest.mark.parametrize("name", ["scene.yade", "stage-001.h5"])
def test_damaged_checkpoint_is_told(gentle, tmp_path, specimens, name):
    oedometer(gentle, tmp_path, specimens=specimens)
    path: Path = tmp_path / "stages" / name
    path.write_bytes(path.read_bytes()[:1000])
    with pytest.raises(GrusError, match=f"{name}: cannot be read .* or a restart") as caught:
        oedometer(gentle, tmp_path, specimens=specimens)
    assert len(str(caught.value).splitlines()) == 1
