import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely.geometry import Point
from shapely.geometry import Polygon as ShapelyPolygon

from grus.errors import GrusError
from grus.specimen import Polygon

L_SHAPE = np.array([[0, 0], [3, 0], [3, 1], [1, 1], [1, 3], [0, 3]], dtype=float)


def test_centroid_area_and_diameter():
    polygon = Polygon(L_SHAPE + [100.0, -7.0])
    # Three unit squares and two more: centroid by hand.
    centroid = (3 * np.array([1.5, 0.5]) + 2 * np.array([0.5, 2.0])) / 5
    np.testing.assert_allclose(polygon.vertices, L_SHAPE - centroid, atol=1e-12)
    assert polygon.measure == pytest.approx(5.0, rel=1e-12)
    assert polygon.equivalent_diameter == pytest.approx(np.sqrt(20 / np.pi), rel=1e-12)
    assert polygon.bounding_radius == pytest.approx(np.hypot(1.9, 1.1), rel=1e-12)
    np.testing.assert_allclose(polygon.box, [[-1.1, -1.1], [1.9, 1.9]], atol=1e-12)


def test_concave_corner_keeps_its_margin():
    polygon = Polygon(L_SHAPE)
    corner = np.array([1.0, 1.0]) - [1.1, 1.1]
    diagonal = np.array([-1.0, -1.0]) / np.sqrt(2)
    points = np.zeros((4, 3))
    for row, step in enumerate([-0.05, 0.25, 0.299, 0.301]):
        points[row, :2] = corner + step * diagonal
    assert polygon.contains(points, 0.3).tolist() == [False, False, False, True]
    assert polygon.contains(points, 0.2).tolist() == [False, True, True, True]


@settings(max_examples=50, deadline=None)
@given(
    radii=st.lists(st.floats(0.3, 2.0), min_size=3, max_size=12),
    clockwise=st.booleans(),
    margin=st.floats(0.0, 0.3),
)
def test_membership_agrees_with_shapely(radii, clockwise, margin):
    angle = np.linspace(0, 2 * np.pi, len(radii), endpoint=False)
    star = np.array(radii)[:, None] * np.column_stack([np.cos(angle), np.sin(angle)])
    polygon = Polygon(1e-3 * star[:: -1 if clockwise else 1])
    reference = ShapelyPolygon(polygon.vertices * 1e3)
    points = np.zeros((200, 3))
    points[:, :2] = np.random.Generator(np.random.PCG64(1)).random((200, 2)) * 4e-3 - 2e-3
    expected = [
        reference.contains(p) and reference.exterior.distance(p) >= margin
        for p in map(Point, points[:, :2] * 1e3)
    ]
    assert polygon.contains(points, margin * 1e-3).tolist() == expected


def test_repeated_vertices_are_dropped():
    polygon = Polygon([[0, 0], [1, 0], [1, 0], [0, 1], [0, 0]])
    assert len(polygon.vertices) == 3
    assert polygon.contains(np.zeros((1, 3)), 0.1).all()


def test_of_diameter_scales_the_shape():
    polygon = Polygon(L_SHAPE).of_diameter(12.6e-3)
    assert polygon.equivalent_diameter == pytest.approx(12.6e-3, rel=1e-12)
    assert polygon.describe()["vertices"] == polygon.vertices.tolist()


@pytest.mark.parametrize(
    "vertices, message",
    [
        ([[0, 0], [1, 0]], "number of polygon vertices = 2: must be at least 3"),
        ([[0, 0], [1, 0], [2, 0]], r"polygon area = 0.0: must be > 0 m2"),
        ([[0, 0], [2, 2], [2, 0], [0, 1]], r"polygon = Self-intersection: must be simple"),
        ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], r"shape of polygon vertices = \(3, 3\)"),
        ([[0, 0], [1, 0], [0, np.nan]], "polygon vertices = not finite: must be finite"),
    ],
)
def test_invalid_vertices(vertices, message):
    with pytest.raises(GrusError, match=message):
        Polygon(vertices)
