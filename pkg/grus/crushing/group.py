"""Crushing of a group of grains in parallel processes."""

import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from grus.card import Card
from grus.crushing.result import CrushingResult
from grus.crushing.test import crush
from grus.errors import GrusError
from grus.files import discard_partial
from grus.host.processes import run_in_processes
from grus.ownership import claim
from grus.specimen.from_card import outline_from_card
from grus.statistics import WeibullFit, fit_weibull

Progress = Callable[[int, int], None]


@dataclass(frozen=True)
class GroupResult:
    """Results of grains 0 .. n-1 of a card, in this order."""

    card: Card
    grains: tuple[CrushingResult, ...]

    @property
    def strengths(self) -> np.ndarray:
        """Strengths (n,) by the first drop of the force [Pa]; of a grain that never broke, the largest stress."""
        return np.array([grain.strength for grain in self.grains])

    @property
    def censored(self) -> np.ndarray:
        """Mask (n,) of the grains that did not break, whose strength is only known to be larger."""
        return np.array([not grain.broken for grain in self.grains])

    def weibull(self, by: str = "first drop") -> WeibullFit:
        """Weibull distribution of the strengths `by` the 'first drop' of the force or by its 'maximum'."""
        if by == "maximum":
            strengths = np.array([grain.max_strength for grain in self.grains])
        elif by == "first drop":
            strengths = self.strengths
        else:
            raise GrusError(f"by = {by!r}; allowed: 'first drop', 'maximum'")
        censored = self.censored if self.censored.any() else None
        return fit_weibull(strengths, censored=censored, seed=self.card.seed)

    def weibull_or_reason(self, by: str = "first drop") -> WeibullFit | str:
        """The same, or in words why these grains do not tell a distribution (too few broke, all equally strong)."""
        try:
            return self.weibull(by)
        except GrusError as error:
            return str(error)


def crush_group(
    card: Card,
    grains: int,
    folder: str | Path,
    jobs: int | None = None,
    progress: Progress | None = None,
) -> GroupResult:
    """Crushes grains 0 .. `grains`-1 of `card`, `jobs` at a time (default: one a core), one process each.

    Each result is written to `folder`/grains as soon as it is there; grains found there are not run again, so a call
    that was interrupted goes on where it was. `progress(done, of)` is called after each grain.
    Raises GrusError when `folder` holds results of another card, or when `grains` or `jobs` is below 1.
    """
    jobs = jobs or len(os.sched_getaffinity(0))
    for name, value in {"grains": grains, "jobs": jobs}.items():
        if value < 1:
            raise GrusError(f"{name} = {value}; allowed: 1 or more")
    outline_from_card(card)  # refuses a bad mesh before anything is written
    store = _Store(card, Path(folder))
    waiting = [grain for grain in range(grains) if not store.has(grain)]
    done = grains - len(waiting)

    def count(*_: object) -> None:
        nonlocal done
        done += 1
        if progress:
            progress(done, grains)

    if progress:
        progress(done, grains)
    if waiting:
        calls = [(card, grain, store) for grain in waiting]
        run_in_processes(_run, calls, min(jobs, len(waiting)), count)
    return GroupResult(card, tuple(store.load(grain) for grain in range(grains)))


def _run(card: Card, grain: int, store: "_Store") -> None:
    store.save(crush(card, grain))


class _Store:
    """Results of one card in a folder."""

    def __init__(self, card: Card, folder: Path) -> None:
        self.key = claim(folder, card)
        self.folder = folder / "grains"
        self.folder.mkdir(exist_ok=True)
        discard_partial(self.folder)

    def path(self, grain: int) -> Path:
        return self.folder / f"grain-{grain:04d}.h5"

    def has(self, grain: int) -> bool:
        try:
            self.load(grain)
        except GrusError:
            return False
        return True

    def load(self, grain: int) -> CrushingResult:
        return CrushingResult.load(self.path(grain), self.key)

    def save(self, result: CrushingResult) -> None:
        result.save(self.path(result.grain), self.key)
