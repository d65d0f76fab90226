"""Tests that come to a bad end say what, where, and what is left of them."""

import math

import pytest
from yade import O

from grus.errors import GrusError
from grus.oedometer import oedometer
from grus.oedometer.test import servo


def disturbed(stage: int, how):
    """Progress that does something to the scene once, in the middle of a stage."""
    done = []

    def tell(share: float, line: str) -> None:
        if share > 0 and servo().stage == stage and not done:
            done.append(how())

    return tell


def cross_platens() -> None:
    top, bottom = (O.bodies[i].state for i in (servo().top, servo().bottom))
    top.pos = bottom.pos - (0, 1e-3, 0)


def lose_a_grain() -> None:
    clump = next(body for body in O.bodies if body.isClump)
    clump.state.vel = (math.nan, 0, 0)


@pytest.mark.parametrize(
    "how, words",
    [(cross_platens, "the platens have met"), (lose_a_grain, "not a number")],
)
def test_bad_end_of_a_stage(gentle, tmp_path, specimens, how, words):
    with pytest.raises(GrusError, match=words) as caught:
        oedometer(gentle, tmp_path, disturbed(2, how), specimens)
    message = str(caught.value)
    scene = tmp_path / "stages" / "scene.yade"
    assert len(message.splitlines()) == 1
    for part in ("plane.toml", "stage 2, load to 60 kPa", f"last good state is {scene}"):
        assert part in message
    # What had been saved is good, and the test goes on from there.
    assert oedometer(gentle, tmp_path, specimens=specimens).stages[-1].kind == "unload"


def test_yade_does_not_print_what_is_told_anyway(gentle, tmp_path, specimens, capfd):
    with pytest.raises(GrusError):
        oedometer(gentle, tmp_path, disturbed(1, cross_platens), specimens)
    assert capfd.readouterr().err == ""


def test_stage_that_does_not_end(gentle, tmp_path, specimens):
    hasty = gentle.with_overrides({"oedometer.max_steps": 200})
    with pytest.raises(
        GrusError, match="oedometer.max_steps = 200: stage 0, seat at 5 kPa has not"
    ):
        oedometer(hasty, tmp_path, specimens=specimens)
    assert (tmp_path / "stages" / "scene.yade").exists()


@pytest.mark.parametrize("there_before", [False, True])
def test_impossible_void_ratio_leaves_the_folder_free(plane, tmp_path, there_before):
    folder = tmp_path / "out"
    if there_before:
        folder.mkdir()
        (folder / "notes.txt").write_text("mine")
    loose = plane.with_overrides({"specimen.void_ratio": 0.9, "preparation.attempts": 1})
    with pytest.raises(GrusError, match="specimen.void_ratio = 0.9: not reached"):
        oedometer(loose, folder)
    left = [path.name for path in folder.iterdir()] if folder.exists() else None
    assert left == (["notes.txt"] if there_before else None)


@pytest.mark.parametrize("table", ["oedometer", "specimen"])
def test_card_without_a_test(plane, tmp_path, table):
    missing = {name: None for name in ("oedometer", table)}
    if table == "specimen":
        missing["preparation"] = None
    with pytest.raises(GrusError, match="is missing; allowed: a table"):
        oedometer(plane.with_overrides(missing), tmp_path / "out")
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    "stages, words",
    [
        (["unload to 5 kPa"], "stage 1"),
        (["load to 100 kPa", "load to 50 kPa"], "stage 2: loads to less"),
        (["load to 100 kPa", "unload to 200 kPa"], "stage 2: unloads to more"),
        (["hold for 1 h"], "stage 1: nothing to hold yet"),
        (["load to -1 kPa"], "stage 1"),
        ([], "too few"),
    ],
)
def test_bad_programs_are_refused_with_the_card(plane, stages, words):
    with pytest.raises(GrusError, match=words) as caught:
        plane.with_overrides({"oedometer.stages": stages})
    assert "oedometer.stages" in str(caught.value)
