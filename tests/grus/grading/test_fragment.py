"""Fragments: labels, volumes, sizes; mass is kept."""

import numpy as np
import pytest

from grus.errors import GrusError
from grus.grading import Fragments
from grus.specimen import Circle, Specimen, Sphere, Stamp, agglomerate, join


def grains(dimension=2, count=3):
    shape = Circle if dimension == 2 else Sphere
    parts = [
        agglomerate(
            shape(10e-3 + 2e-3 * i), 0.9e-3, stamp=Stamp(mean=1.5e-3, deviation=0), seed=5, grain=i
        )
        for i in range(count)
    ]
    return join(parts, np.arange(3 * count).reshape(count, 3)[:, :dimension] * 20e-3)


def row(count, clump=None, radius=1e-3):
    """Elements in a row along x, in one grain."""
    position = np.zeros((count, 3))
    position[:, 0] = 2 * radius * np.arange(count)
    return Specimen(
        dimension=2,
        position=position,
        radius=np.full(count, radius),
        clump=np.arange(count) if clump is None else clump,
        grain=np.zeros(count),
        grain_diameter=[5e-3],
    )


@pytest.mark.parametrize("dimension", [2, 3])
def test_unbroken_grains(dimension):
    specimen = grains(dimension)
    fragments = Fragments.of_labels(specimen, specimen.grain)
    assert fragments.count == 3
    assert fragments.grain.tolist() == [2, 1, 0]  # the largest first
    assert fragments.equivalent_diameter == pytest.approx([14e-3, 12e-3, 10e-3])
    # whole elements inside the outline: less than its diameter, by up to an element all round
    assert (fragments.sieve_size <= fragments.equivalent_diameter).all()
    assert (fragments.sieve_size >= fragments.equivalent_diameter - 4 * 0.9e-3).all()


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("share", [0.0, 0.3, 0.7, 1.0])
def test_mass_is_kept(dimension, share):
    specimen = grains(dimension)
    bonds = specimen.bonds()
    generator = np.random.Generator(np.random.PCG64(7))
    fragments = Fragments.of_bonds(specimen, bonds[generator.random(len(bonds)) < share])
    whole = Fragments.of_labels(specimen, specimen.grain)
    total = whole.mass(2052.0).sum()
    assert fragments.mass(2052.0).sum() == pytest.approx(total, rel=1e-14)
    assert np.bincount(fragments.grain, fragments.volume) == pytest.approx(
        np.bincount(whole.grain, whole.volume), rel=1e-14
    )
    cubes = np.bincount(fragments.grain, fragments.equivalent_diameter**dimension)
    assert cubes == pytest.approx(specimen.grain_diameter**dimension, rel=1e-13)
    assert fragments.grading().passing[-1] == 100
    assert fragments.grading().retained.sum() == pytest.approx(100, rel=1e-14)
    assert (np.diff(fragments.volume) <= 0).all()


def test_without_bonds_every_clump_is_a_fragment():
    specimen = grains()
    fragments = Fragments.of_bonds(specimen, np.empty((0, 2)))
    assert fragments.count == specimen.clump_count
    same = specimen.clump[:, None] == specimen.clump
    assert ((fragments.label[:, None] == fragments.label) == same).all()


def test_labels_do_not_matter_only_who_shares_them():
    specimen = grains()
    by_bonds = Fragments.of_bonds(specimen, specimen.bonds()[::3])
    by_labels = Fragments.of_labels(specimen, 1000 - 7 * by_bonds.label)
    assert (by_bonds.label == by_labels.label).all()
    assert (by_bonds.sieve_size == by_labels.sieve_size).all()


def test_sizes_of_a_row():
    specimen = row(4)
    fragments = Fragments.of_bonds(specimen, np.array([[0, 1], [1, 2]]))
    assert fragments.label.tolist() == [0, 0, 0, 1]
    assert fragments.sieve_size == pytest.approx([2e-3, 2e-3])  # lengthwise through a slot
    assert fragments.equivalent_diameter == pytest.approx(5e-3 * np.sqrt([0.75, 0.25]))
    assert fragments.mass(1000.0) == pytest.approx([3e-3 * np.pi, 1e-3 * np.pi])


def test_sieve_size_in_space_is_the_second_width():
    # 3 x 2 x 1 spheres: the flat slab falls through a square opening lengthwise
    position = np.stack(np.meshgrid(range(3), range(2), [0]), axis=-1).reshape(-1, 3) * 2e-3
    slab = Specimen(
        dimension=3,
        position=position,
        radius=np.full(6, 1e-3),
        clump=np.arange(6),
        grain=np.zeros(6),
        grain_diameter=[5e-3],
    )
    fragments = Fragments.of_bonds(slab, slab.bonds())
    assert fragments.sieve_size == pytest.approx([4e-3])


def test_a_clump_in_two_pieces_is_one_fragment():
    fragments = Fragments.of_bonds(row(3, clump=[0, 1, 0]), np.empty((0, 2)))
    assert fragments.label.tolist() == [0, 1, 0]


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda s: Fragments.of_labels(s, np.zeros(2)), "shape of label = (2,): must be"),
        (lambda s: Fragments.of_labels(s, np.zeros(s.element_count)), "label = [0.]: must be of"),
        (lambda s: Fragments.of_bonds(s, [[0, 10_000]]), "bonds = unknown elements: must be"),
        (lambda s: Fragments.of_bonds(s, []).mass(0.0), "density = 0.0: must be"),
        (lambda s: Fragments.of_bonds(s, []).grading(size="mean"), "size = mean: must be sieve or"),
    ],
)
def test_refusals(call, message):
    with pytest.raises(GrusError) as refusal:
        call(grains())
    assert str(refusal.value).startswith(message)


def test_sieve_size_needs_one_radius_in_a_grain():
    mixed = Specimen(
        dimension=2,
        position=[[0, 0, 0], [2e-3, 0, 0]],
        radius=[1e-3, 0.9e-3],
        clump=[0, 1],
        grain=[0, 0],
        grain_diameter=[4e-3],
    )
    with pytest.raises(GrusError, match=r"^radius = differs in grain \[0\]: must be one in a"):
        Fragments.of_labels(mixed, mixed.grain).sieve_size
