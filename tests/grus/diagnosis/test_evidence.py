"""Which explanation wins, on vectors made by formulas."""

import numpy as np
import pytest
from formula import compared, made_test

from grus.diagnosis.evidence import explanations, log_density
from grus.diagnosis.fingerprint import Fingerprint
from grus.diagnosis.suspect import Known, Unknown
from grus.diagnosis.verdict import decide
from grus.mechanisms import MECHANISMS

BASE = compared(made_test())
CREEP = compared(made_test(creep=1e-4)).measured - BASE.measured
DRIFT = compared(made_test(drift=1e-9)).measured - BASE.measured
SCATTER = np.diag((0.1 * np.abs(BASE.measured) + 1e-6) ** 2)


def known(name: str, change: np.ndarray, sign: int = 1) -> Known:
    mechanism = MECHANISMS[name]
    parameter = mechanism.parameters[0]
    changes = np.array([change, 3 * change])
    one = Fingerprint(mechanism, parameter, parameter.sizes[:2], changes, 0 * changes, sign)
    return Known(one, BASE)


SUSPECTS = [
    known("bond_ageing", CREEP),
    known("instrument_drift", DRIFT),
    known("instrument_drift", DRIFT, -1),
    Unknown("hold", BASE, np.abs(BASE.measured)),
    Unknown("ramp", BASE, np.abs(BASE.measured)),
]


def judged(seed: int = 1, noise: float = 2e-6, **effect: float):
    view = compared(made_test(noise=noise, seed=seed, **effect))
    covariance = SCATTER + view.noise
    generator = np.random.default_rng(seed + 1000)
    level = 0.1 * np.abs(BASE.measured) * generator.standard_normal(len(BASE.measured))
    return decide(explanations(view.measured + level - BASE.measured, covariance, SUSPECTS))


@pytest.mark.parametrize("seed", range(5))
def test_nothing_is_said_of_noise_and_scatter(seed):
    assert judged(seed).kind == "nothing"


@pytest.mark.parametrize("seed", range(5))
def test_creep_is_named(seed):
    found = judged(seed, creep=1.5e-4)
    assert (found.kind, found.named) == ("named", ("bond_ageing",))


@pytest.mark.parametrize("rate", [2e-9, -2e-9])
def test_drift_is_named_whichever_way_it_goes(rate):
    found = judged(drift=rate)
    assert (found.kind, found.named) == ("named", ("instrument_drift",))


def test_two_are_named_together():
    found = judged(creep=2e-4, drift=2e-9)
    assert found.kind == "named" and set(found.named) == {"bond_ageing", "instrument_drift"}


def test_strain_that_no_fingerprint_has_is_unknown():
    """Swelling in the loaded holds: no mechanism of the library gives strain back under constant stress."""
    view = compared(made_test(noise=2e-6, creep=-2e-4))
    found = explanations(view.measured - BASE.measured, SCATTER + view.noise, SUSPECTS)
    assert decide(found).kind == "unknown"


def test_probabilities_add_up_to_one():
    view = compared(made_test(noise=2e-6, creep=5e-5))
    found = explanations(view.measured - BASE.measured, SCATTER + view.noise, SUSPECTS)
    assert sum(one.probability for one in found) == pytest.approx(1)


def test_a_weaker_power_of_the_likelihood_says_less():
    view = compared(made_test(noise=2e-6, creep=1e-4))
    sure, unsure = (
        explanations(view.measured - BASE.measured, SCATTER + view.noise, SUSPECTS, temper)[0]
        for temper in (1.0, 0.1)
    )
    assert sure.probability > unsure.probability


def test_density_is_the_normal_one():
    covariance = np.array([[2.0, 0.5], [0.5, 1.0]])
    x = np.array([0.3, -1.2])
    expected = -0.5 * x @ np.linalg.inv(covariance) @ x - 0.5 * np.log(
        (2 * np.pi) ** 2 * np.linalg.det(covariance)
    )
    assert log_density(x, covariance) == pytest.approx(expected)


def test_an_effect_and_its_opposite_are_no_explanation():
    view = compared(made_test(noise=2e-6, drift=2e-9))
    found = explanations(view.measured - BASE.measured, SCATTER + view.noise, SUSPECTS)
    opposite = {"instrument_drift:strain_rate", "instrument_drift:-strain_rate"}
    assert not any(opposite <= set(one.names) for one in found)


def test_what_leaves_an_order_is_no_explanation():
    view = compared(made_test(noise=2e-6, creep=1.5e-4))
    found = explanations(view.measured - BASE.measured, SCATTER + view.noise, SUSPECTS)
    assert decide(found, whiteness=0.5).kind == "named"
    assert decide(found, whiteness=1e-6).kind == "unknown"
