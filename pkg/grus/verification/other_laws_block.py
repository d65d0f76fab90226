"""A block of about 100 bonded spheres under CohFrict and JCFpm, against the contact bond of Grus."""

from collections.abc import Iterator

import numpy as np

from grus.verification.block import BlockCurve, load_block
from grus.verification.formulas import BondedPair
from grus.verification.laws import grus_law
from grus.verification.other_laws import OTHERS, PART
from grus.verification.row import Row, compare

RADIUS = 1e-3
PAIR = BondedPair(
    "contact",
    radii=(RADIUS, RADIUS),
    kn=2e6,
    ks=1e6,
    tensile=1.0,
    shear=1.5,
    tan_phi=0.5,
    friction=0.5,
)
LOADINGS = {  # velocity of the upper layer [m/s]
    "pulled apart": (0.0, 0.0, 9e-3),
    "sheared": (3e-2, 0.0, 0.0),
    "compressed": (0.0, 0.0, -4.5e-2),
}
STEP = 4e-7  # [s], a quarter of the critical one
STEPS = 2000
GRUS = "Grus"
Curves = dict[str, dict[str, BlockCurve]]

SAME = (
    "The same block, strengths bond by bond, step and speed; no damping, because YADE's takes the sign of each "
    "velocity, which rounding decides where the velocity is zero."
)
AFTERWARDS = {
    "CohFrict": "The whole run, in which most of the bonds break in a cascade after the peak.",
    "JCFpm": "After a break JCFpm keeps the shear force for one step and counts new contacts from where they are "
    "first seen (rows of the pair above); in the cascade after the peak other bonds break.",
}


def block_curves() -> Curves:
    """What the block did, by loading and law."""
    laws = {GRUS: grus_law, **OTHERS}
    return {
        loading: {
            name: load_block(law(PAIR), RADIUS, np.array(velocity), STEP, STEPS)
            for name, law in laws.items()
        }
        for loading, velocity in LOADINGS.items()
    }


def block_rows(curves: Curves) -> Iterator[Row]:
    """Peak force and broken bonds at the peak and at the end."""
    for loading, by_law in curves.items():
        grus = by_law[GRUS]
        for name in OTHERS:
            other = by_law[name]
            case = f"{name}, block of {grus.spheres} spheres: {loading}"
            yield compare(PART, case, "peak force", "N", grus.peak, other.peak, 1e-3, SAME)
            yield compare(
                PART,
                case,
                "bonds broken up to the peak",
                "1",
                grus.broken_at_peak,
                other.broken_at_peak,
                1e-3,
                f"Of {grus.bonds[0]:g} bonds.",
            )
            yield compare(
                PART,
                case,
                "bonds broken at the end",
                "1",
                grus.broken,
                other.broken,
                None if name == "JCFpm" else 1e-3,
                AFTERWARDS[name],
            )
