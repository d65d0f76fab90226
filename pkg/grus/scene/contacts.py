"""Contacts and their forces at one moment, as plain arrays."""

from dataclasses import dataclass

import numpy as np

from grus import _engines

_KINDS = {"ids": np.int32, "bonded": bool, "breakage": np.uint8, "force": float, "point": float}
_WIDTH = {"ids": 2, "point": 3}
NO_ELEMENT = -1


@dataclass(frozen=True)
class Contacts:
    """Contacts of the elements of a specimen, bonded or not, with each other and with walls.

    pairs (c, 2): element indices; -1 first: a wall. Sorted.
    force (c,): normal force of contact and bond together [N], compression positive.
    point (c, 3): contact points [m].
    """

    pairs: np.ndarray
    force: np.ndarray
    point: np.ndarray


def contacts(ids: list[int]) -> Contacts:
    """Contacts of the elements `ids` (as returned by `insert`) in the current scene."""
    table = contact_table(ids)
    return Contacts(table["pairs"], table["force"], table["point"])


def contact_table(ids: list[int]) -> dict[str, np.ndarray]:
    """The same with `bonded` (c,) and `breakage` (c,): 0 unbroken, 1 broken in tension, 2 in shear."""
    raw = _engines.contactTable()
    table = {name: np.frombuffer(raw[name], dtype=kind) for name, kind in _KINDS.items()}
    table |= {name: table[name].reshape(-1, width) for name, width in _WIDTH.items()}
    bodies = table.pop("ids")
    index = np.full(max([*ids, int(bodies.max(initial=0))]) + 1, NO_ELEMENT)
    index[ids] = np.arange(len(ids))
    table["pairs"] = np.sort(index[bodies], axis=1)
    order = np.lexsort(table["pairs"].T[::-1])
    order = order[table["pairs"][order, 1] != NO_ELEMENT]
    return {name: values[order] for name, values in table.items()}
