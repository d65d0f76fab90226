import numpy as np

from grus.specimen.touching import connected_parts, consecutive, largest_part, touching_pairs


def row(*centres: float) -> np.ndarray:
    return np.array([[x, 0.0, 0.0] for x in centres])


def test_pairs_touch_within_the_tolerance_of_the_smaller_radius():
    position, radius = row(0.0, 3.0 + 0.9e-3, 6.0 + 2.0e-3), np.array([2.0, 1.0, 2.0])
    assert touching_pairs(position, radius, tolerance=1e-3).tolist() == [[0, 1]]
    assert touching_pairs(position, radius, tolerance=2e-3).tolist() == [[0, 1], [1, 2]]
    assert touching_pairs(position, radius, tolerance=1e-4).shape == (0, 2)


def test_pairs_are_sorted():
    position = np.array([[2.0, 0, 0], [0, 0, 0], [1.0, np.sqrt(3), 0]])
    assert touching_pairs(position, np.ones(3)).tolist() == [[0, 1], [0, 2], [1, 2]]


def test_connected_parts_are_numbered_by_their_lowest_element():
    assert connected_parts(6, np.array([[1, 5], [0, 4]])).tolist() == [0, 1, 2, 3, 0, 1]
    assert connected_parts(2, np.empty((0, 2), dtype=np.int64)).tolist() == [0, 1]


def test_largest_part():
    position = row(0, 2, 5, 7, 9, 20)
    assert largest_part(position, np.ones(6)).tolist() == [2, 3, 4]
    assert largest_part(row(0, 2, 5, 7), np.ones(4)).tolist() == [0, 1]


def test_consecutive_follows_first_appearance():
    assert consecutive(np.array([7, 3, 7, 9, 3])).tolist() == [0, 1, 0, 2, 1]
