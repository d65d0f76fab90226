import pytest

from grus.diagnosis.search import next_strength

FARTHEST = 7.0


@pytest.mark.parametrize(
    "points, expected",
    [
        ([(0.0, -1.0), (1.0, 1.0)], 0.5),
        ([(0.0, -4.0), (2.0, -1.0), (4.0, 3.0)], 2.5),  # the nearest two
        ([(0.0, -3.0), (6.0, 2.6), (8.0, 2.5)], 6 * 3 / 5.6),  # nearest in strength
        ([(0.0, 0.5), (1.0, -0.5), (8.0, 4.0)], 0.5),  # mixed by noise
        ([(0.0, -4.0), (7.0, -1.0)], 7 + 7 / 3),  # along the line
        ([(0.0, 0.5), (2.0, 2.5)], -0.5),
        ([(0.0, -4.0), (7.0, -3.9)], 14.0),  # not too far
        ([(0.0, -4.0), (7.0, -4.0)], 14.0),  # no line to follow
        ([(0.0, 3.0), (7.0, 2.0)], -7.0),  # effects that fall with strength
        ([(0.0, -0.5)], 7.0),
        ([(0.0, 0.5)], -7.0),
    ],
)
def test_next_strength(points, expected):
    assert next_strength(points, FARTHEST) == pytest.approx(expected)
    assert next_strength(points[::-1], FARTHEST) == pytest.approx(expected)


def test_a_steep_noisy_effect_is_found():
    """Within four runs, from far off."""

    def effect(strength: float) -> float:
        return 2.0 * (strength - 3.3) + 0.1 * (-1) ** round(7 * strength)

    points = [(-9.0, effect(-9.0))]
    for _ in range(4):
        strength = next_strength(points, FARTHEST)
        points.append((strength, effect(strength)))
    assert min(abs(e) for _, e in points) < 0.35
