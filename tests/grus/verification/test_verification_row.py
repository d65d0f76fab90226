"""Rows: deviation, tolerance, outcome."""

from math import inf, isnan, nan

import numpy as np
import pytest

from grus.verification.row import at_most, compare, worst


def row(expected, got, tolerance=1e-3):
    return compare("energy", "case", "work", "J", expected, got, tolerance, "Note.")


def test_deviation_is_relative():
    made = row(-4.0, -3.0)
    assert (made.expected, made.got, made.deviation, made.passed) == (-4.0, -3.0, 0.25, False)
    assert row(4.0, 4.004).passed and not row(4.0, 4.0041).passed


def test_deviation_from_nothing_is_absolute():
    assert row(0.0, -2e-4).deviation == pytest.approx(2e-4)


def test_a_turned_vector_deviates():
    made = row([3.0, 0.0, 4.0], [3.0, 4.0, 0.0])
    assert (made.expected, made.got) == (5.0, 5.0)
    assert made.deviation == pytest.approx(np.sqrt(32) / 5)


@pytest.mark.parametrize("got", [nan, inf])
def test_no_number_does_not_pass(got):
    made = row(1.0, got)
    assert made.passed is False
    assert made.to_dict()["got"] is None and made.to_dict()["passed"] is False


def test_a_row_that_informs_neither_passes_nor_fails():
    assert row(1.0, 2.0, None).passed is None


def test_only_what_exceeds_a_bound_deviates():
    below, above = (
        at_most("time step", "case", "step", "s", 2.0, got, 1e-9, "Note.") for got in (1.0, 2.1)
    )
    assert below.passed and below.got == 1.0 and below.deviation == 0
    assert not above.passed and above.deviation == pytest.approx(0.05)


def test_worst_of_variants():
    good, bad, undefined = row(1.0, 1.0), row(1.0, 2.0), row(1.0, nan)
    assert worst([good, bad]) is bad
    assert isnan(worst([good, undefined, bad]).deviation)
