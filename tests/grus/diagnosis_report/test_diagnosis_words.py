"""What a diagnosis says in words."""

from dataclasses import replace

import pytest
from rich.console import Console

from grus.diagnosis.report import summary
from grus.diagnosis.report.spoken import chances, number, probability, quantity, strain
from grus.diagnosis.report.words import answers

VERDICTS = ("named", "nothing", "cannot_tell", "unknown")


@pytest.mark.parametrize(
    "value, unit, said",
    [
        (15840, "s", "4.4 h"),
        (90, "s", "1.5 min"),
        (3e8, "s", "9.5 years"),
        (2e5, "Pa", "200 kPa"),
        (1e-11, "m/Pa", "10 µm/MPa"),
        (2e-5, "m", "20 µm"),
        (1e-9, "1/s", "0.0086 % a day"),
        (0.15, "1", "0.15"),
        (0.0, "s", "0 s"),
        (3.0, "kg", "3 kg"),
    ],
)
def test_quantities_are_in_the_units_of_an_engineer(value, unit, said):
    assert quantity(value, unit) == said


def test_numbers_have_two_digits():
    assert [number(x) for x in (0.1234, 20.24, 345.6, 100.0)] == ["0.12", "20", "346", "100"]
    assert strain(0.00213) == "0.21 %" and strain(0.0) == "0 %"


def test_nothing_is_certain():
    assert [probability(p) for p in (1.0, 0.5, 0.0)] == ["over 99 %", "50 %", "below 1 %"]
    assert [chances(p) for p in (0.25, 0.0)] == ["p = 0.25", "p < 0.001"]


@pytest.mark.parametrize("verdict", VERDICTS)
@pytest.mark.parametrize("width", [80, 100, 200])
def test_summary_fits_one_screen(request, verdict, width):
    console = Console(width=width, record=True, file=open("/dev/null", "w"))
    console.print(summary(request.getfixturevalue(verdict)))
    lines = console.export_text().splitlines()
    assert len(lines) <= 25 and max(map(len, lines)) <= width


def test_named_says_where_what_how_large_and_what_improves(named):
    told = answers(named)
    assert told.verdict == "The model leaves out static fatigue of bonds."
    by = told.by_question
    assert "of the misfit in stage 4 (hold at 500 kPa for 3.3 d): strain recorded" in by["Where"]
    assert "creep" in by["What"] and "static fatigue of bonds over 99 %" in by["How sure"]
    assert "Reference time" in by["How large"] and "90 %: " in by["How large"]
    assert "each foreseen from all other stages" in by["What improves"]
    assert "times less" in by["What improves"] and "overfit" not in by["What improves"]


def test_overfit_is_the_verdict(named):
    fit = named.improvement
    worse = replace(fit.after, left_out=fit.before.left_out)
    told = answers(replace(named, improvement=replace(fit, after=worse)))
    assert "Overfit" in told.verdict and "overfit" in told.by_question["What improves"]


def test_nothing_and_unknown_say_so(nothing, unknown):
    assert answers(nothing).verdict.startswith("Nothing is left out")
    assert "none of the known mechanisms" in answers(unknown).verdict
    assert "something unknown 90 %" in answers(unknown).by_question["How sure"]


def test_cannot_tell_names_both_and_the_measurement(cannot_tell):
    told = answers(cannot_tell)
    assert "cannot tell static fatigue of bonds from drift" in told.verdict
    assert told.by_question["What would tell"] == "Hold the highest stress 10 times as long."


def test_small_misfits_are_nowhere(nothing):
    small = tuple(replace(one, chi2=1.1 * one.numbers) for one in nothing.misfit)
    told = answers(replace(nothing, misfit=small)).by_question["Where"]
    assert told.startswith("Nowhere")


def test_missing_fingerprints_are_told(named):
    library = replace(named.library, skipped={"wall_friction": "no run came to an end"})
    told = answers(replace(named, library=library)).by_question["What it cannot tell"]
    assert "Not looked for, since runs are missing: side-wall friction." in told
