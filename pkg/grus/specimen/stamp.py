"""Stamp logic: elements are gathered into rigid clumps by stamps of random size and place."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree
from scipy.special import ndtr, ndtri

from grus.specimen.require import require, require_positive
from grus.specimen.touching import connected_parts, consecutive, touching_pairs


@dataclass(frozen=True, kw_only=True)
class Stamp:
    """The stamp of Cho, Martin & Sego (2007), Int. J. Rock Mech. Min. Sci. 44, 997-1010.

    A circle (sphere in space) of radius N(mean, deviation) is pressed at a place that is uniform
    over the box around the outline. The elements whose centres it covers and that no earlier stamp
    has claimed become one clump; when there are none, nothing happens. This is repeated until
    `share` of the elements are claimed.

    mean, deviation: of the stamp radius [m], before the normal distribution is truncated to
        positive values (by its inverse, so that nothing is drawn twice).
    share: in (0, 1]; Cho et al. stop at 0.99.
    leftover: "single": elements that are not claimed, or were caught alone, are clumps of one;
        "merge": each of them joins the touching clump with the fewest members (of equals, the one
        numbered first), in the order of elements. One without touching neighbours stays.
    split: False is the rule of the paper: what one stamp claims is one clump, even when elements
        claimed before lie between its parts. These parts then hold together rigidly across a gap,
        with a strength that no bond has, and a fragment may consist of separate pieces. True
        makes each part that is connected by touching a clump of its own.

    Raises GrusError for values outside these bounds.
    """

    mean: float
    deviation: float
    share: float = 1.0
    leftover: str = "single"
    split: bool = False

    def __post_init__(self) -> None:
        require_positive("stamp mean", self.mean, "m")
        sound = 0 <= self.deviation < np.inf
        require(sound, "stamp deviation", self.deviation, "finite and >= 0 m")
        require(0 < self.share <= 1, "stamp share", self.share, "in (0, 1]")
        allowed = ("single", "merge")
        require(self.leftover in allowed, "stamp leftover", self.leftover, " or ".join(allowed))

    def radius(self, probability: np.ndarray | float) -> np.ndarray:
        """Stamp radius [m] that is not exceeded with the given probability in [0, 1)."""
        if self.deviation == 0:
            return np.full(np.shape(probability), self.mean)
        # By the upper tail: there the spacing of floating-point numbers stays finer than the tail.
        above = (1 - np.asarray(probability)) * ndtr(self.mean / self.deviation)
        return np.maximum(self.mean - self.deviation * ndtri(above), 0.0)

    def press(
        self,
        position: np.ndarray,
        radius: np.ndarray,
        box: np.ndarray,
        generator: np.random.Generator,
    ) -> np.ndarray:
        """Clump (n,) int64 of each element, numbered 0..m-1 by their lowest elements.

        position (n, 3), radius (n,): the elements [m].
        box (2, dimension): lower and upper corner of the box for the stamp centres [m]; all
        elements must lie in it.
        """
        centre = position[:, : box.shape[1]]
        clump = np.full(len(radius), -1, dtype=np.int64)
        target = np.ceil(self.share * len(radius))
        claimed, count = 0, 0
        while claimed < target:
            free = np.flatnonzero(clump < 0)
            for covered in self._stamps(centre[free], box, generator):
                members = free[covered]
                members = members[clump[members] < 0]
                if len(members):
                    clump[members] = count
                    claimed, count = claimed + len(members), count + 1
                if claimed >= target:
                    break
        alone = np.flatnonzero(clump < 0)
        clump[alone] = count + np.arange(len(alone))

        if self.split or self.leftover == "merge":
            pairs = touching_pairs(position, radius)
            if self.split:
                inside = clump[pairs[:, 0]] == clump[pairs[:, 1]]
                clump = connected_parts(len(radius), pairs[inside])
            if self.leftover == "merge":
                clump = _merge_singles(clump, pairs)
        return consecutive(clump)

    def _stamps(
        self, free: np.ndarray, box: np.ndarray, generator: np.random.Generator
    ) -> Iterator[list[int]]:
        """A batch of stamps that cover at least one of the free elements; yields what they cover.

        Most stamps uniform over the box are empty when few elements are left. Then it is quicker
        to aim: a centre uniform in the cube of half width R, the largest radius, about a free
        element chosen at random. The stamp is kept when it covers that element, and then with
        probability 1/(number of free elements covered), as it could have been aimed at each of
        them. Both ways are rejection from an envelope (the box; the n cubes) and leave the very
        same distribution, uniform over the places in the box where the stamp is not empty. The
        smaller envelope is used, so that a stamp is soon found, however small or large it is.
        """
        count, dimension = free.shape
        largest = float(self.radius(1 - 2.0**-53))
        aim = count * (2 * largest) ** dimension < np.prod(box[1] - box[0])
        # Enough for a good part of the free elements; aimed stamps are mostly rejected.
        batch = 64 + (32 if aim else 1) * count
        size = self.radius(generator.random(batch))
        place = generator.random((batch, dimension))
        weight = generator.random(batch)
        if aim:
            target = free[(generator.random(batch) * count).astype(np.int64)]
            arm = largest * (2 * place - 1)
            place = target + arm
            near = (arm**2).sum(axis=1) <= size**2
            near &= ((place >= box[0]) & (place <= box[1])).all(axis=1)
            size, place, weight = size[near], place[near], weight[near]
        else:
            place = box[0] + place * (box[1] - box[0])
        for covered, chance in zip(
            cKDTree(free).query_ball_point(place, size, return_sorted=True), weight
        ):
            if covered and (not aim or chance * len(covered) < 1):
                yield covered


def _merge_singles(clump: np.ndarray, pairs: np.ndarray) -> np.ndarray:
    """Join clumps of one member to the touching clump with the fewest members."""
    clump = consecutive(clump)
    members = np.bincount(clump)
    both_ways = np.concatenate([pairs, pairs[:, ::-1]])
    both_ways = both_ways[np.argsort(both_ways[:, 0], kind="stable")]
    start = np.searchsorted(both_ways[:, 0], np.arange(len(clump) + 1))
    for element in np.flatnonzero(members[clump] == 1):
        own = clump[element]
        if members[own] > 1:  # Another single has joined it meanwhile.
            continue
        around = np.unique(clump[both_ways[start[element] : start[element + 1], 1]])
        if len(around):
            chosen = around[np.argmin(members[around])]
            clump[element] = chosen
            members[own] -= 1
            members[chosen] += 1
    return clump
