import numpy as np
import pytest

from grus.errors import GrusError
from grus.specimen import Circle, Sphere, Stamp, agglomerate, clump_properties, join

STAMP = Stamp(mean=1.0e-3, deviation=0.2e-3)


def grains(count, outline=Circle(6e-3)):
    return [agglomerate(outline, 0.6e-3, stamp=STAMP, seed=1, grain=i) for i in range(count)]


def test_parts_keep_their_order_and_are_numbered_on():
    parts = grains(3)
    offsets = np.array([[0.0, 0.0], [6e-3, 1e-3], [12e-3, 0.0]])
    whole = join(parts, offsets)
    assert whole.element_count == sum(p.element_count for p in parts)
    assert whole.clump_count == sum(p.clump_count for p in parts)
    assert whole.grain_count == 3 and (whole.grain_diameter == 6e-3).all()
    last = whole.grain == 2
    np.testing.assert_array_equal(whole.position[last], parts[2].position + [12e-3, 0, 0])
    clumps_before = parts[0].clump_count + parts[1].clump_count
    np.testing.assert_array_equal(whole.clump[last], parts[2].clump + clumps_before)
    assert whole.meta == {"parts": [p.meta for p in parts]}


def test_bonds_are_those_of_the_parts():
    parts = grains(3)
    # So near that elements of different grains touch.
    nearest = np.zeros((3, 2))
    nearest[1:, 0] = parts[0].position[:, 0].max() - parts[1].position[:, 0].min() + 1e-3, 0.5
    whole = join(parts, nearest)
    starts = np.cumsum([0] + [p.element_count for p in parts[:2]])
    expected = np.concatenate([p.bonds() + start for p, start in zip(parts, starts)])
    np.testing.assert_array_equal(whole.bonds(), expected)


def test_bonds_survive_a_large_offset():
    parts = grains(2)
    whole = join(parts, [[0.5, 0.5], [-40.0, 0.3]])
    assert len(whole.bonds()) == sum(len(p.bonds()) for p in parts)


def test_joined_specimens_join_again():
    two = join(grains(2), [[0.0, 0.0], [6e-3, 0.0]])
    four = join([two, two], [[0.0, 0.0], [0.0, 6e-3]], meta={"made": "by hand"})
    assert four.grain_count == 4 and four.meta == {"made": "by hand"}
    assert clump_properties(four, 1.0).mass.sum() == pytest.approx(
        2 * clump_properties(two, 1.0).mass.sum(), rel=1e-12
    )


def test_space_needs_three_columns():
    parts = grains(2, Sphere(6e-3))
    assert join(parts, [[0, 0, 0], [0, 0, 7e-3]]).dimension == 3
    with pytest.raises(GrusError, match=r"shape of offsets = \(2, 2\): must be \(2, 3\)"):
        join(parts, [[0, 0], [0, 7e-3]])


def test_what_does_not_fit_together():
    plane, space = grains(1)[0], grains(1, Sphere(6e-3))[0]
    thin = agglomerate(Circle(6e-3), 0.6e-3, seed=0, thickness=0.1)
    with pytest.raises(GrusError, match=r"dimension = \[2, 3\]: must be the same in all"):
        join([plane, space], np.zeros((2, 3)))
    with pytest.raises(GrusError, match=r"thickness = \[0.1, 1.0\]: must be the same in all"):
        join([plane, thin], np.zeros((2, 2)))
    with pytest.raises(GrusError, match="number of specimens = 0: must be at least 1"):
        join([], np.zeros((0, 2)))
    with pytest.raises(GrusError, match=r"shape of offsets = \(1, 2\): must be \(2, 2\) or"):
        join([plane, plane], np.zeros((1, 2)))
