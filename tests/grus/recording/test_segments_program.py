"""Cutting records along a program that is given."""

import numpy as np
import pytest
from test_segments import record
from trials import Draw

from grus.card.program import Program
from grus.errors import GrusError
from grus.recording import segments

PROGRAM = ("load to 100 kPa", "load to 200 kPa", "hold for 24 h", "unload to 50 kPa")


def ramps() -> np.ndarray:
    """Seating, one ramp to 200 kPa, a hold, unloading."""
    return 1e3 * np.concatenate(
        [
            np.full(6, 4.0),
            np.linspace(4, 200, 50)[1:],
            np.full(20, 200.0),
            np.linspace(200, 50, 16)[1:],
        ]
    )


def told(found) -> list[tuple]:
    return [(one.kind, one.stage, one.first, one.last) for one in found if one.kind != "event"]


def test_stages_that_the_stress_alone_does_not_tell():
    found = told(segments(record(ramps()), PROGRAM))
    assert [one[:2] for one in found] == [
        ("seat", 0),
        ("load", 1),
        ("load", 2),
        ("hold", 3),
        ("unload", 4),
    ]
    # 100 kPa is reached at reading 29.
    assert abs(found[1][3] - 29) <= 1
    assert found[3][2:] == (54, 74)


def test_stages_of_a_card_are_as_good_as_words():
    stages = Program().read(list(PROGRAM))
    assert segments(record(ramps()), stages) == segments(record(ramps()), PROGRAM)


def test_the_program_may_be_wrong_by_a_tenth():
    plain, off = (told(segments(record(share * ramps()), PROGRAM)) for share in (1.0, 1.07))
    assert [one[:2] for one in off] == [one[:2] for one in plain]
    assert off[3:] == plain[3:]


def test_holds_after_each_other_share_the_time():
    stress = 1e3 * np.repeat([10.0, 50.0], [5, 40])
    program = ("load to 50 kPa", "hold for 1 h", "hold for 3 h")
    found = told(segments(record(stress, time=np.arange(45)), program))
    assert [one[:2] for one in found] == [("seat", 0), ("load", 1), ("hold", 2), ("hold", 3)]
    assert abs(found[2][3] - 15) <= 1


def test_noise_that_hides_a_step():
    draw = Draw(11, 0)
    stress = 1e5 * np.repeat([1.0, 1.05, 2.0], 40) * (1 + 0.02 * draw.gauss(120))
    program = ("load to 100 kPa", "hold for 1 h", "load to 105 kPa", "hold for 1 h")
    program += ("load to 200 kPa", "hold for 1 h")
    found = told(segments(record(stress), program))
    assert [one[1] for one in found] == [2, 3, 4, 5, 6]
    assert abs(found[0][3] - 39) <= 12 and found[-1][2] == 80


@pytest.mark.parametrize(
    "program, message",
    [
        (("load to 400 kPa",), r'stage 1 "load to 400000.0 Pa": the recording has .* kPa there'),
        ((*PROGRAM, "load to 900 kPa"), "program stage 5 .*follows within 10%"),
        (("push",), "program: stage 1: not a stage; allowed: a list of 1 to 1000 stages"),
        ((), "program: too few or too many stages"),
        (("load to 5 s",), "is not a stress"),
        (tuple(f"load to {k} kPa" for k in range(1, 200)), "allowed"),
    ],
)
def test_programs_that_do_not_fit(program, message):
    with pytest.raises(GrusError, match=message):
        segments(record(ramps()), program)
