"""Strengths of the bonds of a specimen against the distribution that the mechanism asks for."""

from pathlib import Path

import numpy as np
from scipy import stats

from grus.card import Card
from grus.mechanisms import MECHANISMS
from grus.oedometer import OedometerTest
from grus.preparation import prepare

ROOT = Path(__file__).resolve().parents[3]


def test_factors_are_normal_and_cut_off_at_0_and_2(tmp_path):
    from yade import O

    plane = Card.from_file(ROOT / "tests" / "cards" / "plane.toml")
    card = MECHANISMS["strength_scatter"].apply(
        plane.with_overrides({"bond.scatter": None}), {"coefficient_of_variation": 0.3}
    )
    OedometerTest(card, prepare(card, tmp_path))
    bonds = [i.phys for i in O.interactions if i.phys.bonded]
    factors = np.array([bond.tensileStrength for bond in bonds]) / card.bond.tensile_strength
    assert len(factors) > 400 and 0 < factors.min() and factors.max() < 2
    law = stats.truncnorm(-1 / 0.3, 1 / 0.3, loc=1, scale=0.3)
    assert stats.kstest(factors, law.cdf).pvalue > 0.01
    shear = np.array([bond.shearStrength for bond in bonds]) / card.bond.shear_strength
    np.testing.assert_allclose(shear, factors, rtol=1e-12)
