"""Several specimens put together as one."""

from collections.abc import Sequence

import numpy as np

from grus.specimen.require import require
from grus.specimen.specimen import Specimen


def join(specimens: Sequence[Specimen], offsets: np.ndarray, meta: dict | None = None) -> Specimen:
    """One specimen of all elements, each part moved by its offset.

    specimens: k parts of the same dimension and thickness.
    offsets (k, 2) or (k, 3) [m]; two columns are enough for plane specimens.
    meta: of the whole; by default {"parts": [meta of each part]}.
    Elements, clumps and grains keep their order and are numbered on from part to part.
    Raises GrusError when there are no parts, or when they do not fit together.
    """
    require(len(specimens) > 0, "number of specimens", len(specimens), "at least 1")
    dimensions = sorted({part.dimension for part in specimens})
    require(len(dimensions) == 1, "dimension", dimensions, "the same in all specimens")
    thicknesses = sorted({part.thickness for part in specimens})
    require(len(thicknesses) == 1, "thickness", thicknesses, "the same in all specimens")

    offsets = np.asarray(offsets, dtype=float)
    columns = (2, 3) if dimensions[0] == 2 else (3,)
    fits = offsets.ndim == 2 and len(offsets) == len(specimens) and offsets.shape[1] in columns
    shapes = " or ".join(f"({len(specimens)}, {column})" for column in columns)
    require(fits, "shape of offsets", offsets.shape, shapes)
    shift = np.zeros((len(specimens), 3))
    shift[:, : offsets.shape[1]] = offsets

    clumps_before = np.cumsum([0] + [part.clump_count for part in specimens[:-1]])
    grains_before = np.cumsum([0] + [part.grain_count for part in specimens[:-1]])
    return Specimen(
        dimension=dimensions[0],
        thickness=thicknesses[0],
        position=np.concatenate([p.position + s for p, s in zip(specimens, shift)]),
        radius=np.concatenate([p.radius for p in specimens]),
        clump=np.concatenate([p.clump + c for p, c in zip(specimens, clumps_before)]),
        grain=np.concatenate([p.grain + g for p, g in zip(specimens, grains_before)]),
        grain_diameter=np.concatenate([p.grain_diameter for p in specimens]),
        meta={"parts": [p.meta for p in specimens]} if meta is None else meta,
    )
