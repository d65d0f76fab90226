"""What a scene looks like at one moment, as plain arrays."""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from grus import _engines
from grus.scene.contacts import NO_ELEMENT, contact_table
from grus.specimen import Specimen


@dataclass(frozen=True)
class Snapshot:
    """Elements and bonds of a specimen at one moment.

    position (n, 3): centres of the elements [m].
    velocity (n, 3): of the elements [m/s].
    bonds (b, 2): element indices of the pairs whose bond holds, smaller index first, sorted.
    broken (k, 2): element indices of the pairs whose bond broke and that still touch, in the same order.
    mode (k,): how these broke, 1 in tension, 2 in shear.
    fragment (n,): index of the fragment of each element; fragments are sets of clumps joined by bonds, numbered
        from the one with the most elements down.
    """

    position: np.ndarray
    velocity: np.ndarray
    bonds: np.ndarray
    broken: np.ndarray
    mode: np.ndarray
    fragment: np.ndarray

    @property
    def fragment_count(self) -> int:
        return int(self.fragment.max()) + 1


def snapshot(specimen: Specimen, ids: list[int]) -> Snapshot:
    """Takes the state of the elements `ids` (as returned by `insert`) from the current scene."""
    bodies = _engines.bodyTable(ids)
    table = contact_table(ids)
    pairs, bonded = table["pairs"], table["bonded"]
    within = pairs[:, 0] != NO_ELEMENT
    broken = within & ~bonded & (table["breakage"] > 0)
    bonds = pairs[within & bonded]
    return Snapshot(
        position=np.frombuffer(bodies["position"]).reshape(-1, 3),
        velocity=np.frombuffer(bodies["velocity"]).reshape(-1, 3),
        bonds=bonds,
        broken=pairs[broken],
        mode=table["breakage"][broken].astype(np.int64),
        fragment=fragments(specimen.clump, bonds),
    )


def fragments(clump: np.ndarray, bonds: np.ndarray) -> np.ndarray:
    """Fragment (n,) of each element from its clump (n,) and the bonds (b, 2), the largest first."""
    count = int(clump.max()) + 1
    links = clump[bonds]
    graph = coo_matrix((np.ones(len(links)), (links[:, 0], links[:, 1])), shape=(count, count))
    fragment = connected_components(graph, directed=False)[1][clump]
    size = np.bincount(fragment)
    rank = np.empty(len(size), dtype=np.int64)
    rank[np.argsort(-size, kind="stable")] = np.arange(len(size))
    return rank[fragment]
