"""Feret widths of bodies whose widths are known, in any position."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from grus.grading.feret import principal_widths
from grus.specimen.lattice import lattice


def corners(*edges):
    return np.stack(np.meshgrid(*[(0.0, edge) for edge in edges]), axis=-1).reshape(-1, len(edges))


@pytest.mark.parametrize("turn", range(4))
@pytest.mark.parametrize("edges", [(1, 1, 1), (1, 2, 3), (0.001, 2, 2), (0, 2, 3), (0, 0, 3)])
def test_edges_of_a_box(edges, turn):
    rotation = Rotation.random(random_state=turn).as_matrix()
    assert principal_widths(corners(*edges) @ rotation) == pytest.approx(edges, abs=1e-8)


def test_a_single_point_has_no_width():
    assert principal_widths(np.ones((1, 3))).tolist() == [0, 0, 0]
    assert principal_widths(np.ones((1, 2))).tolist() == [0, 0]


def test_triangle():
    widths = principal_widths(np.array([[0, 0], [2, 0], [0, 1.0]]))
    assert widths == pytest.approx([2 / np.sqrt(5), np.sqrt(5)])


def test_regular_tetrahedron():
    # narrowest between two opposite edges, edge / sqrt 2; seen from there it is a square
    points = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1.0]])
    assert principal_widths(points) == pytest.approx([2, 2, 2])


@pytest.mark.parametrize("dimension", [2, 3])
def test_no_sampled_direction_is_narrower(dimension):
    generator = np.random.Generator(np.random.PCG64(3))
    for size in (2, 4, 30):
        points = generator.random((size, dimension))
        normal = generator.random((20_000, dimension)) - 0.5
        normal /= np.linalg.norm(normal, axis=1, keepdims=True)
        sampled = np.ptp(points @ normal.T, axis=0).min()
        width = principal_widths(points)[0]
        assert width <= sampled + 1e-12
        if size > dimension:
            assert sampled == pytest.approx(width, rel=0.1)


def test_packing_with_many_equal_facets():
    generator = np.random.Generator(np.random.PCG64(1))
    points = lattice(3, 1.0, 6.0, generator)
    widths = principal_widths(points)
    again = principal_widths(points[::-1] @ Rotation.random(random_state=2).as_matrix())
    assert widths == pytest.approx(again)
    assert 2 * 4 < widths[0] <= widths[1] <= widths[2] <= 12
