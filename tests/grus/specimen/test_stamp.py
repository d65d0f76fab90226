import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.stats import truncnorm

from grus.errors import GrusError
from grus.specimen import Circle, Sphere, Stamp
from grus.specimen.lattice import lattice
from grus.specimen.stamp import _merge_singles
from grus.specimen.stream import Purpose, stream
from grus.specimen.touching import connected_parts, touching_pairs

RADIUS = 0.6e-3


def grain(outline, seed=0):
    position = lattice(
        outline.dimension, RADIUS, outline.bounding_radius, stream(seed, 0, Purpose.LATTICE)
    )
    return position[outline.contains(position, RADIUS)]


def press(stamp, outline, seed=0, position=None):
    position = grain(outline, seed) if position is None else position
    radius = np.full(len(position), RADIUS)
    return position, stamp.press(position, radius, outline.box, stream(seed, 0, Purpose.STAMP))


def extent(position, clump):
    """Largest distance between two centres of one clump."""
    distance = np.linalg.norm(position[:, None] - position[None], axis=2)
    return (distance * (clump[:, None] == clump[None])).max()


@settings(max_examples=60, deadline=None)
@given(
    outline=st.sampled_from([Circle(10e-3), Sphere(6e-3)]),
    mean=st.floats(1e-6, 0.1),
    share=st.floats(0.01, 1.0),
    deviation=st.floats(0.0, 3.0),
    leftover=st.sampled_from(["single", "merge"]),
    split=st.booleans(),
    seed=st.integers(0, 2**32),
)
def test_every_element_is_in_one_clump_whatever_the_stamp(
    outline, mean, share, deviation, leftover, split, seed
):
    stamp = Stamp(
        mean=mean, deviation=deviation * mean, share=share, leftover=leftover, split=split
    )
    position, clump = press(stamp, outline, seed)
    assert clump.shape == (len(position),) and clump.dtype == np.int64
    first = [np.flatnonzero(clump == c)[0] for c in range(clump.max() + 1)]
    assert first == sorted(first)


@settings(max_examples=30, deadline=None)
@given(mean=st.floats(0.3e-3, 4e-3), seed=st.integers(0, 1000))
def test_no_clump_is_wider_than_the_stamp(mean, seed):
    position, clump = press(Stamp(mean=mean, deviation=0.0), Circle(10e-3), seed)
    assert extent(position, clump) <= 2 * mean * (1 + 1e-12)


def test_a_stamp_that_covers_everything_makes_one_clump():
    outline = Circle(10e-3)
    _, clump = press(Stamp(mean=20e-3, deviation=0.0), outline)
    assert (clump == 0).all()


def test_a_stamp_smaller_than_half_the_spacing_makes_single_elements():
    position, clump = press(Stamp(mean=1e-9, deviation=0.0), Sphere(6e-3))
    assert clump.tolist() == list(range(len(position)))


def plain_stamping(stamp, centre, box, generator):
    """The words of the paper, one stamp at a time."""
    clump, count = np.full(len(centre), -1), 0
    while (clump < 0).any():
        place = box[0] + generator.random(box.shape[1]) * (box[1] - box[0])
        covered = np.linalg.norm(centre - place, axis=1) <= stamp.radius(generator.random())
        if (covered & (clump < 0)).any():
            clump[covered & (clump < 0)] = count
            count += 1
    return clump


@pytest.mark.parametrize(
    "outline, stamp",
    [
        (Circle(7e-3), Stamp(mean=1.0e-3, deviation=0.3e-3)),
        (Circle(13e-3), Stamp(mean=0.7e-3, deviation=0.1e-3)),
        (Sphere(4.4e-3), Stamp(mean=1.0e-3, deviation=0.2e-3)),
    ],
    ids=["box and aim", "mostly aim", "space"],
)
def test_same_statistics_as_plain_stamping(outline, stamp):
    position = grain(outline)
    position = position[np.argsort(np.linalg.norm(position, axis=1))][:40]
    centre = position[:, : outline.dimension]

    def figures(clump):
        members = np.bincount(clump)
        return len(members), (members**2).sum(), (members[clump[:7]]).sum()

    ours, plain = [], []
    for seed in range(200):
        ours.append(figures(press(stamp, outline, seed, position)[1]))
        generator = stream(seed, 1, Purpose.STAMP)
        plain.append(figures(plain_stamping(stamp, centre, outline.box, generator)))
    ours, plain = np.array(ours, dtype=float), np.array(plain, dtype=float)
    error = np.sqrt((ours.var(axis=0) + plain.var(axis=0)) / len(ours))
    assert (abs(ours.mean(axis=0) - plain.mean(axis=0)) <= 3.5 * error + 1e-12).all()


def lens(radius, apart):
    """Area common to two circles of equal radius."""
    half = np.minimum(apart / (2 * radius), 1.0)
    return 2 * radius**2 * (np.arccos(half) - half * np.sqrt(1 - half**2))


@pytest.mark.parametrize(
    "width, deviation", [(8.0, 0.25), (200.0, 0.25), (200.0, 0.0)], ids=["box", "aim", "aim same"]
)
def test_stamps_are_uniform_over_the_places_where_they_catch_something(width, deviation):
    # Two elements near each other, and one in the corner of the box, which has a quarter of a disc.
    apart = 1.1
    pair = [[width / 2, 0.45 * width], [width / 2 + apart, 0.45 * width]]
    free = np.array(pair + [[0.0, width]])
    box = np.array([[0.0, 0.0], [width, width]])
    stamp = Stamp(mean=1.0, deviation=deviation)
    generator = stream(3, 0, Purpose.STAMP)
    caught = [tuple(c) for _ in range(2000) for c in stamp._stamps(free, box, generator)]
    assert len(caught) > 10000

    size = stamp.radius((np.arange(4000) + 0.5) / 4000)
    disc, both = np.pi * (size**2).mean(), lens(size, apart).mean()
    area = {(0,): disc - both, (1,): disc - both, (0, 1): both, (2,): disc / 4}
    for covered, expected in area.items():
        share = expected / sum(area.values())
        error = np.sqrt(share * (1 - share) / len(caught))
        assert abs(caught.count(covered) / len(caught) - share) < 4 * error


def test_share_leaves_the_rest_single():
    stamp = dict(mean=2e-3, deviation=0.2e-3)
    _, all_claimed = press(Stamp(**stamp), Circle(30e-3))
    _, half_claimed = press(Stamp(**stamp, share=0.5), Circle(30e-3))
    singles_all = (np.bincount(all_claimed) == 1).sum()
    singles_half = (np.bincount(half_claimed) == 1).sum()
    assert singles_half >= 0.5 * len(half_claimed) - 15 and singles_all < 0.2 * len(all_claimed)


@pytest.mark.parametrize("share", [0.3, 1.0])
@pytest.mark.parametrize("outline", [Circle(20e-3), Sphere(9e-3)], ids=["plane", "space"])
def test_merge_leaves_no_single_element(outline, share):
    stamp = dict(mean=1.0e-3, deviation=0.2e-3, share=share)
    position, single = press(Stamp(**stamp), outline)
    _, merged = press(Stamp(**stamp, leftover="merge"), outline)
    before, after = np.bincount(single), np.bincount(merged)
    assert (before == 1).any() and after.min() >= 2
    # What was a clump of several stays together.
    for clump in np.flatnonzero(before > 1):
        assert len(np.unique(merged[single == clump])) == 1


def test_merge_joins_the_smallest_neighbour_and_keeps_the_lonely():
    # A row: a clump of three, an element alone, a clump of two; and one that touches nothing.
    position = np.zeros((7, 3))
    position[:, 0] = 2 * RADIUS * np.array([0, 1, 2, 3, 4, 5, 20])
    pairs = touching_pairs(position, np.full(7, RADIUS))
    merged = _merge_singles(np.array([0, 0, 0, 1, 2, 2, 3]), pairs)
    assert merged.tolist() == [0, 0, 0, 2, 2, 2, 3]


def test_split_makes_every_clump_connected_and_changes_nothing_else():
    stamp = dict(mean=2.0e-3, deviation=0.4e-3)
    parts = 0
    for seed in range(5):
        position, whole = press(Stamp(**stamp), Circle(20e-3), seed)
        _, split = press(Stamp(**stamp, split=True), Circle(20e-3), seed)
        pairs = touching_pairs(position, np.full(len(position), RADIUS))
        inside = pairs[whole[pairs[:, 0]] == whole[pairs[:, 1]]]
        np.testing.assert_array_equal(split, connected_parts(len(position), inside))
        parts += split.max() - whole.max()
    assert parts > 0


@pytest.mark.parametrize("deviation", [0.2, 1.0, 5.0])
def test_radius_is_the_truncated_normal_distribution(deviation):
    stamp = Stamp(mean=1.0, deviation=deviation)
    probability = np.linspace(0, 1, 101)[1:-1]
    expected = truncnorm.ppf(probability, -1 / deviation, np.inf, loc=1.0, scale=deviation)
    np.testing.assert_allclose(stamp.radius(probability), expected, rtol=1e-9)
    assert stamp.radius(0.0) >= 0 and np.isfinite(stamp.radius(1 - 2.0**-53))


@pytest.mark.parametrize(
    "change, message",
    [
        ({"mean": 0.0}, "stamp mean = 0.0: must be finite and > 0 m"),
        ({"deviation": -1.0}, "stamp deviation = -1.0: must be finite and >= 0 m"),
        ({"share": 0.0}, r"stamp share = 0.0: must be in \(0, 1\]"),
        ({"share": 1.1}, r"stamp share = 1.1: must be in \(0, 1\]"),
        ({"leftover": "drop"}, "stamp leftover = drop: must be single or merge"),
    ],
)
def test_invalid_stamp(change, message):
    with pytest.raises(GrusError, match=message):
        Stamp(**({"mean": 1.0, "deviation": 0.1} | change))
