"""Grading curves: per cent by mass that pass a sieve, against its opening."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from grus.errors import GrusError, one_line
from grus.grading.sieves import opening, sieve_series
from grus.specimen.require import require


@dataclass(frozen=True, eq=False)
class Grading:
    """A grading curve, straight between its points over the logarithm of the size.

    sizes (k,): openings of the sieves [m], rising, at least two.
    passing (k,): per cent by mass that pass each of them, rising or constant, the last 100.

    The curve is 100 above the last sieve. Below the first it is 0 when nothing passes that sieve;
    otherwise it is not known there, and asking for it is refused.
    Raises GrusError when the points are not like this.
    """

    sizes: np.ndarray
    passing: np.ndarray

    def __post_init__(self) -> None:
        for name in ("sizes", "passing"):
            try:
                value = np.array(getattr(self, name), dtype=np.float64)
            except (TypeError, ValueError):
                shown = one_line(repr(getattr(self, name)))[:60]
                raise GrusError(f"{name} = {shown}: must be numbers") from None
            value.flags.writeable = False
            object.__setattr__(self, name, value)
        sizes, passing = self.sizes, self.passing
        require(sizes.ndim == 1 and sizes.size >= 2, "sizes", sizes.tolist(), "two or more sieves")
        require(passing.shape == sizes.shape, "shape of passing", passing.shape, f"{sizes.shape}")
        _require_all((sizes > 0) & (sizes < np.inf), "sizes", sizes, "finite and > 0 m")
        _require_all(np.diff(sizes) > 0, "sizes", sizes[1:], "rising")
        _require_all((passing >= 0) & (passing <= 100), "passing", passing, "in 0..100 %")
        _require_all(np.diff(passing) >= 0, "passing", passing[1:], "rising with the size")
        require(passing[-1] == 100, "passing of the largest sieve", passing[-1], "100 %")

    @classmethod
    def of_table(cls, rows: Iterable[tuple[float | str, float]]) -> "Grading":
        """From pairs of sieve and per cent passing, in any order.

        A sieve is a number in m or a text with its unit, "9.5 mm". Raises GrusError as above, and
        for sieves that are no lengths.
        """
        pairs = sorted(((opening(sieve), share) for sieve, share in rows), key=lambda row: row[0])
        return cls(*(np.array([row[i] for row in pairs], dtype=object) for i in (0, 1)))

    @classmethod
    def of_masses(
        cls, sizes: np.ndarray, masses: np.ndarray, sieves: np.ndarray | None = None
    ) -> "Grading":
        """From the size (n,) [m] and mass (n,) [any unit] of each grain.

        sieves (k,): openings [m], rising; the series R20 over all sizes by default. A grain passes
        a sieve as large as itself. Raises GrusError for sizes or masses that are not positive, and
        when a grain is larger than all sieves.
        """
        sizes, masses = np.asarray(sizes, dtype=float), np.asarray(masses, dtype=float)
        same = sizes.ndim == 1 and sizes.size > 0 and masses.shape == sizes.shape
        require(same, "shape of sizes and masses", (sizes.shape, masses.shape), "one list each")
        _require_all((sizes > 0) & (sizes < np.inf), "sizes", sizes, "finite and > 0 m")
        _require_all((masses > 0) & (masses < np.inf), "masses", masses, "finite and > 0")
        if sieves is None:
            sieves = sieve_series(sizes.min(), sizes.max())
        sieves = np.asarray(sieves, dtype=float)
        largest = sizes.max()
        require(
            largest <= sieves[-1], "largest sieve", sieves[-1], f"at least {largest} m, a grain"
        )
        order = np.argsort(sizes, kind="stable")
        below = np.concatenate([[0.0], np.cumsum(masses[order])])
        below = below[np.searchsorted(sizes[order], sieves, side="right")]
        return cls(sieves, 100 * (below / below[-1]))

    @property
    def retained(self) -> np.ndarray:
        """Per cent by mass (k,) that pass a sieve but not the next smaller one; first the pan."""
        return np.diff(self.passing, prepend=0.0)

    def passing_at(self, size: np.ndarray | float) -> np.ndarray:
        """Per cent passing at any sizes [m]; GrusError where the curve is not known."""
        size = np.asarray(size, dtype=float)
        known = self.passing[0] == 0 or not size.size or size.min() >= self.sizes[0]
        found = f"{self.passing[0]:g} % pass the smallest sieve, {self.sizes[0]:g} m"
        require(known, "passing", found, f"known down to {np.min(size, initial=np.inf):g} m")
        return np.interp(np.log(size), np.log(self.sizes), self.passing)

    def size_at(self, percent: float) -> float:
        """Smallest size [m] that so many per cent by mass (> 0, at most 100) pass."""
        require(0 < percent <= 100, "percent", percent, "in (0, 100]")
        above = int(np.searchsorted(self.passing, percent))
        found = f"{self.passing[0]:g} % at the smallest sieve, {self.sizes[0]:g} m"
        require(above > 0 or self.passing[0] == percent, "passing", found, f"at most {percent:g} %")
        if self.passing[above] == percent:
            return float(self.sizes[above])
        low, high = self.passing[above - 1 : above + 1]
        left, right = np.log(self.sizes[above - 1 : above + 1])
        return float(np.exp(left + (right - left) * (percent - low) / (high - low)))

    @property
    def d10(self) -> float:
        """Effective size [m]."""
        return self.size_at(10)

    @property
    def d15(self) -> float:
        """Size that 15 % pass [m]."""
        return self.size_at(15)

    @property
    def d50(self) -> float:
        """Median size [m]."""
        return self.size_at(50)

    @property
    def d60(self) -> float:
        """Size that 60 % pass [m]."""
        return self.size_at(60)

    @property
    def uniformity(self) -> float:
        """Coefficient of uniformity Cu = D60 / D10 [-]."""
        return self.d60 / self.d10

    @property
    def curvature(self) -> float:
        """Coefficient of curvature Cc = D30^2 / (D10 D60) [-]."""
        return self.size_at(30) ** 2 / (self.d10 * self.d60)


def _require_all(good: np.ndarray, key: str, values: Sequence, allowed: str) -> None:
    bad = np.flatnonzero(~good)
    require(not len(bad), key, values[bad[0]] if len(bad) else None, allowed)
