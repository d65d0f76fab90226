"""Noise from readings close to each other, and readings as straight pieces."""

import numpy as np
import pytest
from trials import Draw

from grus.recording.noise import count, noise_level, stress_noise
from grus.recording.pieces import fit_line, straight_pieces


@pytest.mark.parametrize("number", range(5))
@pytest.mark.parametrize("slope", [0.0, 30.0])
def test_noise_of_a_line_with_jumps(number, slope):
    draw = Draw(7, number)
    x = np.sort(draw.random(400))
    values = slope * x + 100 * (x > 0.3) - 50 * (x > 0.7) + 0.5 * draw.gauss(400)
    assert noise_level(values, x) == pytest.approx(0.5, rel=0.2)


def test_few_readings_tell_no_noise():
    assert noise_level(np.array([1.0, 2.0, 1.0]), np.arange(3.0)) == 0.0


@pytest.mark.parametrize("number", range(5))
def test_noise_of_stress_follows_the_stress(number):
    draw = Draw(8, number)
    level = np.repeat([1e4, 1e5, 1e6], 200)
    found = stress_noise(level * (1 + 0.01 * draw.gauss(600)), np.arange(600.0))
    for one in (1e4, 1e5, 1e6):
        assert np.median(found[level == one]) == pytest.approx(0.01 * one, rel=0.25)


def test_one_count_of_the_instrument():
    draw = Draw(9, 0)
    values = 0.1 * np.round(0.7 * draw.gauss(100))
    assert count(values) == pytest.approx(0.1)
    assert count(np.repeat([10.0, 20.0, 40.0], 20)) == 0.0
    assert count(np.zeros(20)) == 0.0


def test_pieces_end_where_the_lines_do():
    x = np.arange(90.0)
    y = np.concatenate([np.zeros(30), 2 * np.arange(30.0), np.full(30, 100.0)])
    noise = np.full(90, 0.5)
    found = straight_pieces(x, y + 0.5 * Draw(1, 1).gauss(90), noise, 9.0, 13.5)
    assert [first for first, _ in found][:1] == [0] and found[-1][1] == 89
    assert {last for _, last in found} & {28, 29, 30, 31} and (60, 89) in found


def test_the_partition_is_the_best_one():
    draw = Draw(2, 2)
    x, y, noise = np.arange(9.0), 3 * draw.gauss(9), np.ones(9)

    def cost(bounds):
        total = 0.0
        for first, end in zip(bounds, bounds[1:]):
            own = slice(first, end)
            line = fit_line(x[own], y[own], noise[own])
            fitted = np.interp(x[own], x[own][[0, -1]], [line.start, line.end])
            level = np.sum((y[own] - y[own].mean()) ** 2) + 2.0
            total += min(level, np.sum((y[own] - fitted) ** 2) + 3.0)
        return total

    every = [[0, *(i for i in range(1, 9) if mask >> (i - 1) & 1), 9] for mask in range(256)]
    found = straight_pieces(x, y, noise, 2.0, 3.0)
    assert cost([first for first, _ in found] + [9]) == pytest.approx(min(map(cost, every)))


def test_line_and_its_errors():
    x, noise = np.array([0.0, 1.0, 2.0, 3.0]), np.ones(4)
    line = fit_line(x, 5 + 2 * x, noise)
    assert (line.start, line.end) == pytest.approx((5, 11))
    assert line.start_error == pytest.approx(np.sqrt(1 / 4 + 1.5**2 / 5))
    level = fit_line(np.zeros(2), np.array([1.0, 3.0]), np.ones(2))
    assert (level.start, level.end) == (2.0, 2.0)
