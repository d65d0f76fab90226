"""Tables of runs: grids, points spread over ranges, what stands on a command line."""

import numpy as np
import pytest

from grus.campaign import options
from grus.campaign.plan import Range, grid, spread
from grus.campaign.results import results
from grus.campaign.screen import screen
from grus.campaign.table import table
from grus.card import CardError
from grus.errors import GrusError


def test_grid_has_every_combination():
    assert grid({}) == [{}]
    assert grid({"a": [1, 2], "b": ["x"]}) == [{"a": 1, "b": "x"}, {"a": 2, "b": "x"}]


@pytest.mark.parametrize("plan", ["sobol", "latin-hypercube"])
def test_points_fill_their_ranges(plan):
    ranges = {"a": Range(1, 3, "MPa"), "b": Range(0, 1)}
    points = spread(plan, ranges, 16, seed=4)
    assert points == spread(plan, ranges, 16, seed=4) != spread(plan, ranges, 16, seed=5)
    assert all(point["a"].endswith(" MPa") for point in points)
    a = np.array([float(point["a"].split()[0]) for point in points])
    b = np.array([point["b"] for point in points])
    for shares in ((a - 1) / 2, b):
        # One point in each sixteenth.
        assert sorted((16 * shares).astype(int)) == list(range(16))


def test_rows_change_the_card(card):
    rows = table("crush", card, [{"crush.peak_drop": 0.1}, {"crush.peak_drop": 0.2}], [3, 4], 2)
    assert len(rows) == 8 and len({row.run.key for row in rows}) == 8
    assert rows[-1].changes == {"crush.peak_drop": 0.2, "seed": 4, "grain": 1}
    assert rows[-1].run.card.crush.peak_drop == 0.2 and rows[-1].run.card.seed == 4
    assert table("crush", card, [{}])[0].run.card == card


def test_results_hold_changes_and_figures(runs, expected):
    rows = table("crush", runs[0].card, [{}], range(len(runs)))
    found = results(rows, expected)
    assert list(found["seed"]) == list(range(len(runs)))
    assert list(found["peak.strength"]) == [o.figures["peak.strength"] for o in expected.values()]
    shown = screen(rows, expected)
    assert shown.row_count == 1, "runs that differ in their seed only are one setting"
    few = dict(list(expected.items())[:1])
    assert len(results(rows, few)) == 1, "what was not begun is left out"


def test_command_line():
    assert options.seeds("1-3, 7") == [1, 2, 3, 7]
    assert options.choices("bond.kind=parallel,contact") == ("bond.kind", ["parallel", "contact"])
    assert options.choices("a=1, 2.5,true,3 MPa") == ("a", [1, 2.5, True, "3 MPa"])
    assert options.span("a=1..3 MPa") == ("a", Range(1, 3, "MPa"))
    assert options.span("a=-.5..2.5e3") == ("a", Range(-0.5, 2500))


@pytest.mark.parametrize(
    "read, text",
    [
        (options.seeds, "3-1"),
        (options.seeds, "a"),
        (options.seeds, ""),
        (options.choices, "a"),
        (options.choices, "=1"),
        (options.span, "a=1"),
        (options.span, "a=x..y"),
    ],
)
def test_nonsense_on_the_command_line_is_refused(read, text):
    with pytest.raises(GrusError, match=f"= '{text}'; allowed: "):
        read(text)


def test_impossible_tables_are_refused(card):
    with pytest.raises(GrusError, match="3..1; allowed: low..high"):
        options.span("a=3..1")
    with pytest.raises(GrusError, match="points = 12; allowed: .* power of two"):
        spread("sobol", {"a": Range(0, 1)}, 12, 1)
    with pytest.raises(GrusError, match="plan = 'random'"):
        spread("random", {"a": Range(0, 1)}, 4, 1)
    with pytest.raises(GrusError, match="no ranges"):
        spread("sobol", {}, 4, 1)
    with pytest.raises(GrusError, match="a: given twice"):
        options.named([("a", 1), ("a", 2)])
    with pytest.raises(GrusError, match="seed: given twice"):
        options.named([("seed", 1)], {"seed"})
    with pytest.raises(GrusError, match="grains = 2; allowed: .* 1 in an oedometer"):
        table("oedometer", card, [{}], grains=2)
    with pytest.raises(CardError, match="bond.tensile_strength"):
        table("crush", card, [{"bond.tensile_strength": "1 kg"}])
