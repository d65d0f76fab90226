import numpy as np
import pytest

from grus.errors import GrusError
from grus.specimen import Circle, Sphere


@pytest.mark.parametrize("shape, dimension", [(Circle, 2), (Sphere, 3)])
def test_round_outline_contains_up_to_the_margin(shape, dimension):
    outline = shape(4.0)
    points = np.zeros((3, 3))
    points[:, dimension - 1] = [1.49, 1.5, 1.51]
    assert outline.dimension == dimension
    assert outline.contains(points, 0.5).tolist() == [True, True, False]
    assert outline.contains(points, 0.0).all()


def test_circle_looks_at_x_and_y_only():
    assert Circle(2.0).contains(np.array([[0.0, 0.0, 9.0]]), 0.5).all()


@pytest.mark.parametrize("shape, measure", [(Circle, np.pi), (Sphere, 4 / 3 * np.pi)])
def test_round_outline_measures(shape, measure):
    outline = shape(2.0)
    assert outline.measure == pytest.approx(measure, rel=1e-15)
    assert outline.equivalent_diameter == pytest.approx(2.0, rel=1e-15)
    assert outline.bounding_radius == 1.0
    assert outline.box.tolist() == [[-1.0] * outline.dimension, [1.0] * outline.dimension]
    assert outline.of_diameter(3.0) == shape(3.0)


@pytest.mark.parametrize("diameter", [0.0, -1.0, float("inf"), float("nan")])
def test_invalid_diameter(diameter):
    with pytest.raises(GrusError, match="^diameter = .*: must be finite and > 0 m$"):
        Circle(diameter)
