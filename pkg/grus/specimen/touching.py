"""Which elements touch, and which are connected by touching."""

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

TOLERANCE = 1e-6
"""Widest gap that still counts as touching, in radii of the smaller element [-]."""


def touching_pairs(
    position: np.ndarray, radius: np.ndarray, tolerance: float = TOLERANCE
) -> np.ndarray:
    """Pairs of elements whose gap is at most `tolerance` times the smaller radius.

    position (n, 3) [m], radius (n,) [m]. Returns (k, 2) int64 with i < j, sorted by i, then j.
    """
    reach = 2 * radius.max() * (1 + tolerance)
    pairs = cKDTree(position).query_pairs(reach, output_type="ndarray").astype(np.int64)
    first, second = pairs.T
    distance = np.linalg.norm(position[first] - position[second], axis=1)
    gap = distance - radius[first] - radius[second]
    pairs = pairs[gap <= tolerance * np.minimum(radius[first], radius[second])]
    return pairs[np.lexsort((pairs[:, 1], pairs[:, 0]))]


def connected_parts(count: int, pairs: np.ndarray) -> np.ndarray:
    """Label (count,) int64 of the connected part of each element, numbered by lowest element.

    pairs (k, 2): the links between the elements 0..count-1.
    """
    ends = tuple(pairs.T.astype(np.int32))  # The graph routines take 32-bit indices only.
    links = coo_array((np.ones(len(pairs)), ends), shape=(count, count))
    return consecutive(connected_components(links, directed=False)[1])


def largest_part(position: np.ndarray, radius: np.ndarray) -> np.ndarray:
    """Indices (k,) of the largest set of elements connected by touching, in ascending order.

    Of several sets of the same size it is the one that holds the lowest index.
    """
    part = connected_parts(len(radius), touching_pairs(position, radius))
    return np.flatnonzero(part == np.bincount(part).argmax())


def consecutive(label: np.ndarray) -> np.ndarray:
    """Renumber labels (n,) to int64 0..m-1 without gaps, in the order of first appearance."""
    _, first, inverse = np.unique(label, return_index=True, return_inverse=True)
    rank = np.empty(len(first), dtype=np.int64)
    rank[np.argsort(first)] = np.arange(len(first))
    return rank[inverse]
