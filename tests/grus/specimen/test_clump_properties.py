import numpy as np
import pytest

from grus.errors import GrusError
from grus.specimen import (
    Specimen,
    Sphere,
    Stamp,
    agglomerate,
    clump_properties,
    clump_volume,
    element_volume,
)

RADIUS, DENSITY, THICKNESS = 0.6e-3, 2052.0, 0.8
DISC = DENSITY * np.pi * RADIUS**2 * THICKNESS
BALL = DENSITY * 4 / 3 * np.pi * RADIUS**3


def one_clump(position, dimension=2, radius=None) -> Specimen:
    count = len(position)
    return Specimen(
        dimension=dimension,
        thickness=THICKNESS,
        position=position,
        radius=np.full(count, RADIUS) if radius is None else radius,
        clump=np.zeros(count),
        grain=np.zeros(count),
        grain_diameter=[1.0],
    )


def test_volumes():
    disc, ball = (one_clump(np.zeros((1, 3)), dimension) for dimension in (2, 3))
    assert element_volume(disc) * DENSITY == pytest.approx([DISC], rel=1e-14)
    assert element_volume(ball) * DENSITY == pytest.approx([BALL], rel=1e-14)
    pair = one_clump([[0, 0, 0], [1, 0, 0]], 3, [RADIUS, 2 * RADIUS])
    assert clump_volume(pair) * DENSITY == pytest.approx([9 * BALL], rel=1e-14)


def test_two_discs():
    pair = one_clump([[5.0, 1.0, 0], [5.0, 1.0 + 2 * RADIUS, 0]])
    centre, mass, inertia = clump_properties(pair, DENSITY)
    assert mass == pytest.approx([2 * DISC], rel=1e-13)
    np.testing.assert_allclose(centre, [[5.0, 1.0 + RADIUS, 0.0]], rtol=1e-13)
    # About z: each 1/2 m r^2 and m r^2; about the line of centres only 1/4 m r^2.
    expected = DISC * RADIUS**2 * np.diag([2 * (1 / 4 + 1), 2 / 4, 2 * (1 / 2 + 1)])
    np.testing.assert_allclose(inertia, [expected], rtol=1e-9, atol=1e-12 * expected.max())


def test_hexagon_of_seven_discs():
    angle = np.pi / 3 * np.arange(6)
    ring = 2 * RADIUS * np.column_stack([np.cos(angle), np.sin(angle), np.zeros(6)])
    centre, mass, inertia = clump_properties(one_clump(np.vstack([[0, 0, 0], ring])), DENSITY)
    np.testing.assert_allclose(centre, np.zeros((1, 3)), atol=1e-18)
    assert mass == pytest.approx([7 * DISC], rel=1e-13)
    polar = DISC * RADIUS**2 * (7 / 2 + 6 * 4)
    np.testing.assert_allclose(
        inertia, [polar * np.diag([0.5, 0.5, 1.0])], rtol=1e-12, atol=1e-12 * polar
    )


def test_two_unequal_spheres():
    pair = one_clump([[0, 0, 0], [0, 0, 3 * RADIUS]], 3, [RADIUS, 2 * RADIUS])
    centre, mass, inertia = clump_properties(pair, DENSITY)
    np.testing.assert_allclose(centre, [[0, 0, 3 * RADIUS * 8 / 9]], rtol=1e-12)
    along = 2 / 5 * BALL * RADIUS**2 * (1 + 8 * 4)
    across = along + BALL * 8 / 9 * (3 * RADIUS) ** 2  # reduced mass times distance squared
    np.testing.assert_allclose(
        inertia, [np.diag([across, across, along])], rtol=1e-12, atol=1e-12 * across
    )


def test_a_single_element_has_its_own_inertia():
    _, _, inertia = clump_properties(one_clump([[7.0, -3.0, 2.0]], 3), DENSITY)
    np.testing.assert_allclose(inertia, [2 / 5 * BALL * RADIUS**2 * np.eye(3)], rtol=1e-12)


def test_properties_turn_and_move_with_the_body():
    body = agglomerate(Sphere(6e-3), RADIUS, stamp=Stamp(mean=1.2e-3, deviation=0), seed=2)
    turn = np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]])
    moved = Specimen(
        dimension=3,
        position=body.position @ turn.T + [1.0, 2.0, 3.0],
        radius=body.radius,
        clump=body.clump,
        grain=body.grain,
        grain_diameter=body.grain_diameter,
    )
    before, after = clump_properties(body, DENSITY), clump_properties(moved, DENSITY)
    np.testing.assert_allclose(after.centre, before.centre @ turn.T + [1, 2, 3], rtol=1e-12)
    np.testing.assert_allclose(
        after.inertia, turn @ before.inertia @ turn.T, atol=1e-9 * before.inertia.max()
    )


def test_parallel_axes_join_the_clumps_to_the_whole():
    body = agglomerate(Sphere(6e-3), RADIUS, stamp=Stamp(mean=1.2e-3, deviation=0), seed=2)
    parts = clump_properties(body, DENSITY)
    whole = clump_properties(one_clump(body.position, 3), DENSITY)
    arm = parts.centre - whole.centre[0]
    steiner = [m * (d @ d * np.eye(3) - np.outer(d, d)) for m, d in zip(parts.mass, arm)]
    assert parts.mass.sum() == pytest.approx(whole.mass[0], rel=1e-12)
    np.testing.assert_allclose(
        parts.inertia.sum(axis=0) + np.sum(steiner, axis=0),
        whole.inertia[0],
        atol=1e-12 * whole.inertia.max(),
    )


def test_invalid_density():
    with pytest.raises(GrusError, match="density = 0.0: must be finite and > 0 kg/m3"):
        clump_properties(one_clump(np.zeros((1, 3))), 0.0)
