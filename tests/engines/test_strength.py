"""Random strengths in YADE belong to seed, grain and elements, and to nothing else."""

import pytest
from scenes import card, running
from scipy import stats
from yade import O

from grus.crushing import CrushingTest
from grus.specimen import Specimen
from grus.specimen.from_card import grain_from_card


def factors(test: CrushingTest) -> dict[tuple, float]:
    """Strength factor of each bond by the numbers of its elements."""
    index = {body: i for i, body in enumerate(test.ids)}
    return {
        tuple(sorted((index[i.id1], index[i.id2]))): i.phys.strengthFactor
        for i in O.interactions
        if i.phys.bonded
    }


WEIBULL = {"bond__scatter__kind": "weibull", "bond__scatter__modulus": 4}
NORMAL = {"bond__scatter__kind": "normal", "bond__scatter__coefficient_of_variation": 0.2}


def test_no_scatter_is_exactly_the_strength():
    running(0)
    bonds = [i.phys for i in O.interactions if i.phys.bonded]
    assert {b.tensileStrength for b in bonds} == {1e6} == {b.shearStrength for b in bonds}


@pytest.mark.parametrize("scatter", [WEIBULL, NORMAL])
def test_same_seed_same_factors(scatter):
    first = factors(CrushingTest(card(**scatter), grain=3))
    assert factors(CrushingTest(card(**scatter), grain=3)) == first
    assert factors(CrushingTest(card(**scatter), grain=4)) != first
    other = factors(CrushingTest(card(seed=2, **scatter), grain=3))
    shared = set(first) & set(other)
    assert all(first[pair] != other[pair] for pair in shared)


def test_factor_does_not_depend_on_body_ids():
    model = card(**WEIBULL)
    grain = grain_from_card(model)
    first = factors(CrushingTest(model, specimen=grain))
    # The same elements in the same grain, but inserted after others: other ids, same numbers in the grain.
    O.reset()
    test = CrushingTest.__new__(CrushingTest)
    from grus.scene import InteractionEngines, bond, grain_material, insert
    from yade import utils
    from yade.wrapper import NewtonIntegrator

    for x in range(17):
        O.bodies.append(utils.wall(-1.0 - x, axis=0, material=grain_material(model)))
    test.ids = insert(grain, grain_material(model))
    engines = InteractionEngines()
    O.engines = engines.list + [NewtonIntegrator()]
    bond(grain, engines)
    assert factors(test) == first


def test_factors_follow_the_weibull_law():
    values = []
    for grain in range(12):
        values += factors(CrushingTest(card(**WEIBULL), grain=grain)).values()
    assert len(values) > 1500
    assert stats.kstest(values, stats.weibull_min(4).cdf).pvalue > 0.01


def test_grain_factor_is_shared_and_has_the_size_effect():
    scatter = {"bond__grain_scatter__modulus": 3}
    plain = set(factors(CrushingTest(card(**scatter), grain=5)).values())
    assert len(plain) == 1
    sized = scatter | {"bond__grain_scatter__reference_diameter": "6.3 mm"}
    (factor,) = set(factors(CrushingTest(card(**sized), grain=5)).values())
    assert factor == pytest.approx(plain.pop() * 2 ** (-2 / 3), rel=1e-9)


def test_specimen_is_what_the_scene_bonds():
    test = CrushingTest(card())
    assert set(factors(test)) == {tuple(pair) for pair in test.specimen.bonds()}
    assert isinstance(test.specimen, Specimen)
    bonds = [i.phys for i in O.interactions if i.phys.bonded]
    assert not any(b.bondNormal or b.contactNormal or b.elasticEnergy() for b in bonds)
