import numpy as np
import pytest

from grus.errors import GrusError
from grus.specimen.lattice import lattice
from grus.specimen.stream import Purpose, stream
from grus.specimen.touching import touching_pairs

RADIUS = 0.7e-3


def block(dimension: int, seed: int = 0, extent: float = 12e-3) -> np.ndarray:
    return lattice(dimension, RADIUS, extent, stream(seed, 0, Purpose.LATTICE))


@pytest.mark.parametrize("dimension, neighbours", [(2, 6), (3, 12)])
def test_every_inner_element_has_the_coordination_of_close_packing(dimension, neighbours):
    position = block(dimension)
    pairs = touching_pairs(position, np.full(len(position), RADIUS))
    touching = np.bincount(pairs.ravel(), minlength=len(position))
    inner = np.linalg.norm(position, axis=1) < 12e-3 - 2.01 * RADIUS
    assert inner.sum() > 100
    assert (touching[inner] == neighbours).all()


@pytest.mark.parametrize("dimension", [2, 3])
def test_neighbours_touch_and_nothing_overlaps(dimension):
    position = block(dimension, extent=8e-3)
    distance = np.linalg.norm(position[:, None] - position[None], axis=2)
    nearest = (distance + np.eye(len(position))).min(axis=1)
    np.testing.assert_allclose(nearest, 2 * RADIUS, rtol=1e-12)


def test_space_lattice_is_hexagonal_and_not_cubic():
    # Second shell: an element straight above two layers on, 4 sqrt(2/3) radii away, only in ABAB.
    position = block(3, extent=8e-3)
    middle = position[np.argmin(np.linalg.norm(position, axis=1))]
    distance = np.linalg.norm(position - middle, axis=1) / RADIUS
    assert (abs(distance - 4 * np.sqrt(2 / 3)) < 1e-9).sum() == 2


@pytest.mark.parametrize(
    "dimension, fraction", [(2, np.pi / np.sqrt(12)), (3, np.pi / np.sqrt(18))]
)
def test_packing_fraction_of_a_big_block(dimension, fraction):
    extent = 40 * RADIUS if dimension == 2 else 20 * RADIUS
    counts = [len(block(dimension, seed, extent)) for seed in range(20)]
    packed = np.mean(counts) * (RADIUS / extent) ** dimension
    assert packed == pytest.approx(fraction, rel=5e-3)


def test_plane_angle_is_uniform_over_a_sixth_of_a_turn():
    angles = []
    for seed in range(300):
        position = block(2, seed, extent=4 * RADIUS)
        i, j = touching_pairs(position, np.full(len(position), RADIUS))[0]
        x, y = (position[j] - position[i])[:2]
        angles.append(np.arctan2(y, x) % (np.pi / 3))
    counts, _ = np.histogram(angles, bins=6, range=(0, np.pi / 3))
    assert ((counts - 50.0) ** 2 / 50.0).sum() < 20.5  # chi-square, 5 degrees of freedom, p = 0.001


def test_space_axis_is_uniform_over_directions():
    # The c axis of each block: the direction between the second neighbours found above.
    axes = []
    for seed in range(200):
        position = block(3, seed, extent=6 * RADIUS)
        arm = position - position[np.argmin(np.linalg.norm(position, axis=1))]
        length = np.linalg.norm(arm, axis=1) / RADIUS
        axes.append(arm[np.argmin(abs(length - 4 * np.sqrt(2 / 3)))])
    axes = np.array(axes) / np.linalg.norm(axes, axis=1, keepdims=True)
    second_moment = axes.T @ axes / len(axes)
    np.testing.assert_allclose(second_moment, np.eye(3) / 3, atol=0.1)


@pytest.mark.parametrize("dimension", [2, 3])
def test_offset_moves_the_lattice_within_one_cell(dimension):
    # With a free offset, the element nearest to the origin lies anywhere within the widest hole.
    nearest = [
        np.linalg.norm(block(dimension, seed, 6 * RADIUS), axis=1).min() / RADIUS
        for seed in range(200)
    ]
    hole = 2 / np.sqrt(3) if dimension == 2 else np.sqrt(2)
    assert max(nearest) <= hole + 1e-9
    assert np.quantile(nearest, 0.9) > 0.7 * hole and min(nearest) < 0.35 * hole


def test_plane_lattice_lies_in_z_0_and_within_the_extent():
    position = block(2)
    assert not position[:, 2].any()
    assert np.linalg.norm(position, axis=1).max() <= 12e-3


@pytest.mark.parametrize(
    "arguments, message",
    [
        ((4, 1.0, 2.0), "dimension = 4: must be 2 or 3"),
        ((2, -1.0, 2.0), "element_radius = -1.0: must be finite and > 0 m"),
        ((3, 1.0, float("nan")), "extent = nan: must be finite and > 0 m"),
    ],
)
def test_invalid_arguments(arguments, message):
    with pytest.raises(GrusError, match=message):
        lattice(*arguments, stream(0, 0, Purpose.LATTICE))
