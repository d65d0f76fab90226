import json

import numpy as np
import pytest

from grus.errors import GrusError
from grus.specimen import Circle, Polygon, Sphere, Stamp, agglomerate
from grus.specimen.touching import connected_parts, touching_pairs

PAPER_STAMP = Stamp(mean=1.0e-3, deviation=0.2e-3)
ROUNDING = 2.0**-25
"""Of a place, in radii of an element: `on_grid` moves each coordinate by at most half of that."""
BAR = Polygon([[0, 0], [20e-3, 0], [20e-3, 5e-3], [0, 5e-3]])


def paper_grain(seed=0, grain=0):
    return agglomerate(Circle(12.6e-3), 0.6e-3, stamp=PAPER_STAMP, seed=seed, grain=grain)


def test_grain_of_the_reference_paper():
    grains = [paper_grain(seed) for seed in range(20)]
    elements = np.mean([g.element_count for g in grains])
    # Centres lie within 5.7 mm, and each takes up an area of 2 sqrt(3) r^2.
    assert elements == pytest.approx(np.pi * 5.7**2 / (2 * np.sqrt(3) * 0.6**2), rel=0.02)
    assert np.mean([g.clump_count for g in grains]) == pytest.approx(50, abs=3)
    assert np.mean([len(g.bonds()) for g in grains]) == pytest.approx(169, abs=6)
    assert len({g.element_count for g in grains}) > 1


@pytest.mark.parametrize("outline", [Circle(12.6e-3), Sphere(10e-3), BAR])
def test_elements_lie_inside_without_overlap_and_in_one_piece(outline):
    specimen = agglomerate(outline, 0.6e-3, seed=3, random_orientation=False)
    assert outline.contains(specimen.position, 0.6e-3 * (1 - ROUNDING)).all()
    arm = specimen.position[:, None] - specimen.position[None]
    distance = np.linalg.norm(arm, axis=2) + np.eye(specimen.element_count)
    assert distance.min() >= 1.2e-3 * (1 - ROUNDING)
    pairs = touching_pairs(specimen.position, specimen.radius)
    assert not connected_parts(specimen.element_count, pairs).any()


def test_number_of_elements_does_not_depend_on_the_direction_of_the_outline():
    turned = [[np.cos(0.4), np.sin(0.4)], [-np.sin(0.4), np.cos(0.4)]]
    counts = [
        [agglomerate(o, 0.6e-3, seed=s).element_count for s in range(150)]
        for o in (BAR, Polygon(BAR.vertices @ turned))
    ]
    means, variances = np.mean(counts, axis=1), np.var(counts, axis=1)
    assert abs(means[0] - means[1]) < 3.5 * np.sqrt(variances.sum() / 150)


def test_random_orientation_turns_the_filled_outline():
    fixed = agglomerate(BAR, 0.6e-3, seed=5, random_orientation=False)
    turned = agglomerate(BAR, 0.6e-3, seed=5)
    assert np.ptp(fixed.position[:, 1]) < 5e-3 < 15e-3 < np.ptp(fixed.position[:, 0])
    lengths = [np.linalg.norm(one.position, axis=1) for one in (fixed, turned)]
    np.testing.assert_allclose(*lengths, rtol=0, atol=0.6e-3 * 2 * ROUNDING)
    assert (fixed.clump == turned.clump).all()
    angle = [
        np.arctan2(*agglomerate(BAR, 1e-3, seed=s).position[0, 1::-1])
        - np.arctan2(*agglomerate(BAR, 1e-3, seed=s, random_orientation=False).position[0, 1::-1])
        for s in range(200)
    ]
    counts, _ = np.histogram(np.mod(angle, 2 * np.pi), bins=4, range=(0, 2 * np.pi))
    assert ((counts - 50.0) ** 2 / 50.0).sum() < 16.3  # chi-square, 3 degrees, p = 0.001


@pytest.mark.parametrize("outline", [Circle(12.6e-3), Sphere(8e-3)])
def test_same_seed_same_specimen(outline):
    def make(seed, grain):
        return agglomerate(outline, 0.6e-3, stamp=PAPER_STAMP, missing=0.05, seed=seed, grain=grain)

    first, again = make(8, 2), make(8, 2)
    assert first.content_hash() == again.content_hash()
    for other in (make(9, 2), make(8, 3)):
        assert other.position.shape != first.position.shape or (
            (other.position != first.position).any()
        )


def test_stamp_and_missing_draw_from_streams_of_their_own():
    plain = agglomerate(Circle(12.6e-3), 0.6e-3, seed=1)
    assert (plain.position == paper_grain(1).position).all()
    assert (plain.clump == np.arange(plain.element_count)).all()


def test_meta_tells_what_made_it():
    meta = paper_grain(seed=6, grain=7).meta
    assert (meta["seed"], meta["grain"], meta["missing"]) == (6, 7, 0.0)
    assert meta["outline"] == {"shape": "circle", "diameter": 12.6e-3}
    assert meta["stamp"]["mean"] == 1.0e-3
    assert json.loads(json.dumps(meta)) == meta


def test_grain_diameter_and_thickness():
    specimen = agglomerate(BAR, 0.6e-3, seed=0, thickness=0.05)
    assert specimen.thickness == 0.05
    assert specimen.grain_diameter == pytest.approx([np.sqrt(4 * 100e-6 / np.pi)], rel=1e-12)


@pytest.mark.parametrize(
    "arguments, message",
    [
        ({"element_radius": 0.0}, "element_radius = 0.0: must be finite and > 0 m"),
        ({"element_radius": 8e-3}, "element_radius = 0.008: must be below 0.0063 m, the outline"),
        ({"element_radius": 6.2e-3}, "element_radius = 0.0062: must be small enough that an el"),
        ({"missing": 1.0}, r"missing = 1.0: must be a fraction in \[0, 1\)"),
        ({"seed": -1}, "seed = -1: must be >= 0"),
        ({"grain": -1}, "grain = -1: must be >= 0"),
        ({"thickness": 0.0}, "thickness = 0.0: must be finite and > 0 m"),
    ],
)
def test_invalid_arguments_are_refused_in_one_line(arguments, message):
    arguments = {"element_radius": 0.6e-3, "seed": 0} | arguments
    with pytest.raises(GrusError, match=message) as refusal:
        agglomerate(Circle(12.6e-3), **arguments)
    assert "\n" not in str(refusal.value)
