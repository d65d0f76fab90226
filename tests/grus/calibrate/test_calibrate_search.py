"""The search, on tests that formulas answer: what it finds, that it goes on, what it says of what it cannot know."""

import numpy as np
import pytest
from conftest import STRENGTHS
from stand_in import GRAINS, grain_strength

from grus.calibrate import calibrate, read_targets
from grus.errors import GrusError
from grus.statistics import fit_weibull

STRENGTH = 'bond.tensile_strength = { low = "0.5 MPa", high = "4 MPa" }\n'


def test_finds_what_the_targets_ask_for(card, stand_in, write, tmp_path):
    stand_in()
    found = calibrate(card, read_targets(write(STRENGTHS), card), tmp_path, 40)
    strength, modulus = found.best.values
    # The fit to so few grains does not give back the law's own modulus and scale, but multiples of modulus and logarithm.
    unit = fit_weibull([grain_strength(card, grain) for grain in range(GRAINS)])
    ratio = unit.modulus / card.bond.scatter.modulus
    assert modulus == pytest.approx(4 / ratio, rel=0.12)
    scale = np.log(unit.sigma0 / float(card.bond.tensile_strength)) * unit.modulus
    assert strength == pytest.approx(1.7e6 / np.exp(scale / 4), rel=0.05)
    assert found.best.misfit < 2
    assert len(found.trials) == 40 and found.runs == 40 * GRAINS and found.failed == 0
    low, high = found.intervals.low, found.intervals.high
    assert all(a < s < b for a, s, b in zip(low, found.best.shares, high))
    assert found.intervals.fixed == (True, True)
    calibrated = found.calibrated
    assert calibrated.bond.shear_strength == calibrated.bond.tensile_strength == strength


def test_intervals_follow_the_tolerances(card, stand_in, write, tmp_path):
    stand_in()
    text = f'[parameters]\n{STRENGTH}[targets]\nyield_stress = {{ value = "800 kPa", tolerance = "%s" }}'
    widths = []
    for tolerance in ("50 kPa", "150 kPa"):
        found = calibrate(card, read_targets(write(text % tolerance), card), tmp_path, 30)
        widths.append(found.intervals.high[0] - found.intervals.low[0])
        # The stand-in's own interval, at 95 %, is a tenth of the yield stress to each side.
        deviation = ((float(tolerance.split()[0]) * 1e3) ** 2 + (0.1 * 8e5 / 1.96) ** 2) ** 0.5
        assert widths[-1] * 3.5e6 == pytest.approx(2 * 1.96 * deviation / 0.4, rel=0.15)
    assert widths[1] > 2 * widths[0]


def test_what_no_target_fixes_is_told(card, stand_in, write, tmp_path):
    stand_in()
    text = f'[parameters]\n{STRENGTH}contact.normal_stiffness = {{ low = "1e9 N/m", high = "9e9 N/m" }}\n'
    text += '[targets]\nyield_stress = { value = "800 kPa", tolerance = "50 kPa" }'
    found = calibrate(card, read_targets(write(text), card), tmp_path, 30)
    assert found.intervals.fixed == (True, False)


def test_curve_of_several_specimens(card, stand_in, write, tmp_path):
    stand_in()
    text = """
    specimens = 2
    [parameters]
    contact.normal_stiffness = { low = "1e9 N/m", high = "9e9 N/m", logarithmic = true }
    [targets.compression_curve]
    stress = ["50 kPa", "100 kPa", "300 kPa"]
    axial_strain = [0, 0.00005, 0.00025]
    tolerance = 1e-5
    """
    found = calibrate(card, read_targets(write(text), card), tmp_path, 30)
    assert found.best.values[0] == pytest.approx(3e9, rel=0.05)
    answer = found.best.answers["compression_curve"]
    assert answer.values[0] == 0 and answer.error[2] > 0
    assert found.runs == 60


def test_cut_off_search_goes_on(card, stand_in, write, tmp_path):
    targets = read_targets(write(STRENGTHS), card)
    whole = stand_in()
    expected = calibrate(card, targets, tmp_path, 14)
    cut = stand_in(end=95)
    with pytest.raises(KeyboardInterrupt):
        calibrate(card, targets, tmp_path, 14)
    rest = stand_in(stored=cut.stored)
    found = calibrate(card, targets, tmp_path, 14)
    assert found.trials == expected.trials
    assert cut.simulated + rest.simulated == whole.simulated


def test_more_trials_go_on_from_the_last(card, stand_in, write, tmp_path):
    targets = read_targets(write(STRENGTHS), card)
    whole = stand_in()
    expected = calibrate(card, targets, tmp_path, 15)
    first = stand_in()
    calibrate(card, targets, tmp_path, 10)  # ends within a group
    rest = stand_in(stored=first.stored)
    assert calibrate(card, targets, tmp_path, 15).trials == expected.trials
    assert first.simulated + rest.simulated == whole.simulated


def test_progress_counts_simulations(card, stand_in, write, tmp_path):
    stand_in()
    calls = []
    targets = read_targets(write(STRENGTHS), card)
    calibrate(card, targets, tmp_path, 5, progress=lambda *now: calls.append(now))
    assert calls == [(done, 5 * GRAINS) for done in range(1, 5 * GRAINS + 1)]


def test_target_that_is_not_shown_counts_as_missed(card, stand_in, write, tmp_path):
    stand_in()
    text = f'[parameters]\n{STRENGTH}[targets]\nyield_stress = {{ value = "1 MPa", tolerance = "50 kPa" }}'
    found = calibrate(card, read_targets(write(text), card), tmp_path, 12)
    lost = [one for one in found.trials if one.answers["yield_stress"].missing]
    assert lost and all(one.misfit == 1e4 and one.values[0] >= 3e6 for one in lost)
    assert found.best.misfit < 100


def test_no_target_shown_at_all_is_refused(card, stand_in, write, tmp_path):
    stand_in()
    text = '[parameters]\nbond.tensile_strength = { low = "4 MPa", high = "5 MPa" }\n'
    text += '[targets]\nyield_stress = { value = "1 MPa", tolerance = "50 kPa" }'
    with pytest.raises(
        GrusError, match="no trial shows any target, the first: not found in the test"
    ):
        calibrate(card, read_targets(write(text), card), tmp_path, 8)


def test_values_that_the_card_refuses_together_are_missed(card, stand_in, write, tmp_path):
    stand_in()
    text = """
    [parameters]
    specimen.minimum_diameter = { low = "9 mm", high = "11.8 mm" }
    specimen.rms_diameter = { low = "10 mm", high = "14 mm" }
    [targets]
    yield_stress = { value = "400 kPa", tolerance = "50 kPa" }
    """
    found = calibrate(card, read_targets(write(text), card), tmp_path, 8)
    refused = [one for one in found.trials if one.answers["yield_stress"].missing]
    assert {one.answers["yield_stress"].missing for one in refused} == {"refused by the card"}
    assert all(one in refused for one in found.trials if one.values[0] > one.values[1])
    assert 0 < len(refused) < 8 and found.runs == 8 - len(refused)
