"""Crushing of a group of grains, which is a campaign."""

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from grus import campaign
from grus.campaign.store import Tell, quiet
from grus.card import Card
from grus.crushing.arrays import from_arrays
from grus.crushing.result import CrushingResult
from grus.errors import GrusError
from grus.files import discard_partial
from grus.ownership import claim
from grus.specimen.from_card import outline_from_card
from grus.statistics import WeibullFit, fit_weibull

Progress = Callable[[int, int], None]
STORE = "store"
"""Folder of the campaign in that of the results."""


@dataclass(frozen=True)
class GroupResult:
    """Results of grains of a card.

    grains: those of grains 0 .. n-1 that did not fail, in this order.
    failed: number of each of the others -> what went wrong, in one line.
    """

    card: Card
    grains: tuple[CrushingResult, ...]
    failed: dict[int, str] = field(default_factory=dict)

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
    tell: Tell = quiet,
) -> GroupResult:
    """Crushes grains 0 .. `grains`-1 of `card` in a campaign, `jobs` at a time (default: one a core), one process each.

    Each result is written to `folder`/grains as soon as it is there; grains found there are not run again, so a call
    that was interrupted goes on where it was. The campaign's store is `folder`/store. A grain that fails does not stop the
    others; the next call tries it again unless the card is to blame. `progress(done, of)` is called after each grain,
    `tell(line)` when there is something to say.
    Raises GrusError when `folder` holds results of another card, when `grains` or `jobs` is below 1, or when every grain
    failed; OSError when `folder` cannot be written.
    """
    for name, value in {"grains": grains, "jobs": jobs}.items():
        if value is not None and value < 1:
            raise GrusError(f"{name} = {value}; allowed: 1 or more")
    outline_from_card(card)  # refuses a bad mesh before anything is written
    files = _Files(card, Path(folder))
    results = {grain: found for grain in range(grains) if (found := files.find(grain))}
    failed: dict[int, str] = {}
    before = len(results)

    def ended(outcome: campaign.Outcome) -> None:
        if outcome.failed is None:
            results[outcome.grain] = from_arrays(outcome.record, outcome.arrays)
            files.save(results[outcome.grain])
        else:
            failed[outcome.grain] = outcome.failed

    campaign.campaign(
        [campaign.Run("crush", card, grain) for grain in range(grains) if grain not in results],
        campaign.Store(Path(folder) / STORE),
        jobs,
        progress=progress and (lambda done, _: progress(before + done, grains)),
        ended=ended,
        tell=tell,
    )
    if not results:
        raise GrusError(failed[min(failed)])
    return GroupResult(
        card, tuple(results[grain] for grain in sorted(results)), dict(sorted(failed.items()))
    )


class _Files:
    """Results of one card in a folder."""

    def __init__(self, card: Card, folder: Path) -> None:
        self.key = claim(folder, card)
        self.folder = folder / "grains"
        self.folder.mkdir(exist_ok=True)
        discard_partial(self.folder)

    def path(self, grain: int) -> Path:
        return self.folder / f"grain-{grain:04d}.h5"

    def find(self, grain: int) -> CrushingResult | None:
        """None when there is none that can be read."""
        try:
            return CrushingResult.load(self.path(grain), self.key)
        except GrusError:
            return None

    def save(self, result: CrushingResult) -> None:
        result.save(self.path(result.grain), self.key)
