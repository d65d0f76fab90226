"""The preparation of a card's specimen, from its grading to its rest under the seating stress."""

import hashlib
import json
from collections.abc import Callable
from pathlib import Path

import numpy as np

from grus.card import Card
from grus.errors import GrusError
from grus.preparation.compaction import Compaction, start_box
from grus.preparation.diameters import base, diameters
from grus.preparation.exo import grow, place, solid_fraction
from grus.preparation.grain import sized_grain
from grus.preparation.prepared import FORMAT, PreparedSpecimen
from grus.preparation.seating import seat
from grus.preparation.stream import Step, stream
from grus.specimen import Specimen, join
from grus.version import __version__

Progress = Callable[[str], None]
SECTIONS = (
    "dimension",
    "thickness",
    "seed",
    "element",
    "contact",
    "bond",
    "agglomerate",
    "specimen",
    "preparation",
)
"""Keys and tables of a card that decide how its specimen is prepared."""
LOOSER = 0.9
"""Share of the box that exo-spheres fill, over that of a packing that came to rest too dense."""


def specimen_key(card: Card) -> str:
    """SHA-256 of all that decides the prepared specimen: these tables, the seed among them, and the version."""
    content = {name: value for name, value in card.to_dict().items() if name in SECTIONS}
    if card.mesh_path is not None:
        content["mesh"] = hashlib.sha256(card.mesh_path.read_bytes()).hexdigest()
        content["agglomerate"].pop("mesh")
    text = json.dumps([FORMAT, __version__, content], sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()


def prepare(card: Card, folder: str | Path, progress: Progress | None = None) -> PreparedSpecimen:
    """The prepared specimen of `card`: taken from `folder` if it is there, else made and saved there.

    The file is specimen-<first 16 digits of the key>.h5. `progress` is called with a line on each step.
    Raises GrusError as `make`.
    """
    _needs_specimen(card)
    key = specimen_key(card)
    path = Path(folder) / f"specimen-{key[:16]}.h5"
    if path.exists():
        found = PreparedSpecimen.load(path)
        if found.key == key:
            return found
    prepared = make(card, progress)
    path.parent.mkdir(parents=True, exist_ok=True)
    prepared.save(path)
    return prepared


def make(card: Card, progress: Progress | None = None) -> PreparedSpecimen:
    """Makes the specimen of `card`, in the current YADE scene, which is emptied first.

    Raises GrusError when the card has no specimen, when its grains do not fit the box, when the void ratio cannot be
    had, or when a bond breaks.
    """
    _needs_specimen(card)
    tell = progress or (lambda line: None)
    sizes = diameters(card)
    tell(f"{len(sizes)} grains of {1e3 * sizes.min():.3g} to {1e3 * sizes.max():.3g} mm")
    grains = [sized_grain(card, i, float(d)) for i, d in enumerate(sizes)]
    compacted = _compacted(card, grains, tell)
    tell("bonded, coming to rest")
    prepared = seat(card, *compacted, specimen_key(card))
    _check_void_ratio(card, prepared.void_ratio)
    tell(f"at rest, void ratio {prepared.void_ratio:.4f}")
    return prepared


def _compacted(card: Card, grains: list[Specimen], tell: Progress) -> tuple[Specimen, np.ndarray]:
    """Grains (as one specimen) at rest at the void ratio asked for, and the corners of their box [m]."""
    target, tolerance = card.specimen.void_ratio, card.preparation.void_ratio_tolerance
    reach = np.array([float((np.linalg.norm(g.position, axis=1) + g.radius).max()) for g in grains])
    fraction, margin = solid_fraction(card), 0.0
    found: list[float] = []
    for attempt in range(card.preparation.attempts):
        size = start_box(card, reach, base(card), fraction)
        tell(f"growing exo-spheres, packing {attempt + 1}")
        centres = _exo_spheres(card, reach, size, attempt)
        parts = join(grains, centres, meta={"maker": "preparation"})
        tell("compacting")
        compaction = Compaction(card, parts, size, attempt, margin)
        reached = compaction.run()
        if compaction.press.leaks:
            tell("grains were pressed out of the box")
            continue
        found += reached
        tell(f"void ratio {found[-1]:.4f}, {found[-2]:.4f} when first at rest")
        if abs(found[-1] - target) <= 0.8 * tolerance:
            return compaction.result()
        if found[-1] < target:
            # The way on which the grains come together decides how loose they can rest.
            margin += target - found[-1]
            fraction *= LOOSER
    if not found:
        raise GrusError(
            f"{card.source}: preparation.compaction_speed = {card.preparation.compaction_speed:g}: grains were pressed "
            "out of the box; allowed: less"
        )
    raise GrusError(
        f"{card.source}: specimen.void_ratio = {target:g}: not reached in {card.preparation.attempts} packing(s); "
        f"allowed: what these grains can have, here {min(found):.3f} to {max(found):.3f}"
    )


def _exo_spheres(card: Card, reach: np.ndarray, size: np.ndarray, attempt: int) -> np.ndarray:
    generator = stream(card.seed, Step.PLACES, attempt)
    centre = None
    if (size > 2 * reach.max()).all():
        centre = place(card.preparation.start_factor * reach, size, generator)
    if centre is None:
        raise GrusError(
            f"{card.source}: preparation.exo_solid_fraction = {solid_fraction(card):g}: the exo-spheres find no place "
            f"at {card.preparation.start_factor:g} of their size; allowed: less, or a smaller preparation.start_factor"
        )
    return grow(card, centre, reach, size)


def _check_void_ratio(card: Card, reached: float) -> None:
    target, tolerance = card.specimen.void_ratio, card.preparation.void_ratio_tolerance
    if abs(reached - target) > tolerance:
        raise GrusError(
            f"{card.source}: specimen.void_ratio = {target:g}: {reached:.4f} after seating; "
            f"allowed: within {tolerance:g}, or a larger preparation.void_ratio_tolerance"
        )


def _needs_specimen(card: Card) -> None:
    if card.specimen is None:
        raise GrusError(f"{card.source}: specimen is missing; allowed: a table [specimen]")
