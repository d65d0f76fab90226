"""[preparation]: how the specimen of an oedometer comes to be."""

from collections.abc import Iterator
from typing import Any

from grus.card.contact import UNITS
from grus.card.errors import Problem
from grus.card.interval import NOT_NEGATIVE, POSITIVE, Interval
from grus.card.pydantic_adapter import Section, key
from grus.card.quantity import Measure, Quantity
from grus.card.values import Number, Whole


class Preparation(Section):
    """Exo-spheres grown in the box, grains in their place, brought to rest under a small stress."""

    start_factor: float = key(
        Number(Interval(above=0, below=1)),
        "Size of the exo-spheres when they are placed at random, over their final size.",
        default=0.6,
    )
    exo_solid_fraction: float | None = key(
        Number(Interval(above=0, below=1)),
        "Share of the box that the grown exo-spheres fill, before the platens close.",
        default=None,
        default_text="0.65 in the plane, 0.35 in space",
    )
    normal_stiffness: Measure | None = key(
        Quantity(UNITS, POSITIVE, "5e8 N/m"),
        "Normal stiffness of the exo-spheres when they begin to grow.",
        default=None,
        default_text="a sixth of contact.normal_stiffness",
    )
    stiffness_growth: float = key(
        Number(Interval(least=1)),
        "Factor by which that stiffness grows with the exo-spheres.",
        default=100,
    )
    wall_stiffness: Measure | None = key(
        Quantity(UNITS, POSITIVE, "5e7 N/m"),
        "Normal stiffness of the walls while the exo-spheres grow.",
        default=None,
        default_text="a tenth of normal_stiffness",
    )
    friction: float = key(
        Number(NOT_NEGATIVE),
        "Least friction coefficient between grains while they are compacted. It starts at "
        "four times contact.friction_coefficient and is lowered until the void ratio is met.",
        default=0,
    )
    compaction_overlap: float = key(
        Number(Interval(above=0, most=0.1)),
        "Mean overlap of grains at rest under the seating stress while they are compacted, over "
        "the radius of an element; it decides how soft they are then.",
        default=0.005,
    )
    compaction_speed: Measure = key(
        Quantity({"m/s": "a speed"}, POSITIVE, "0.2 m/s"),
        "Largest speed of a platen while grains are compacted; grains that are pressed together faster rest denser.",
        default="0.2 m/s",
    )
    void_ratio_tolerance: float = key(
        Number(POSITIVE),
        "Largest distance of the prepared from the asked void ratio.",
        default=0.005,
    )
    attempts: int = key(
        Whole(1, 1000),
        "How many packings are tried until one has the void ratio.",
        default=5,
    )
    seating_stress: Measure = key(
        Quantity({"Pa": "a stress"}, POSITIVE, "5 kPa"),
        "Axial stress at which the specimen is brought to rest.",
        default="5 kPa",
    )
    seating_speed: Measure = key(
        Quantity({"m/s": "a speed"}, POSITIVE, "0.01 m/s"),
        "Largest speed of a platen once the grains are bonded.",
        default="0.01 m/s",
    )
    bond_strength: Measure | None = key(
        Quantity({"Pa": "a stress", "N": "a force"}, POSITIVE, "1e9 Pa"),
        "Tensile and shear strength of bonds until the specimen is at rest.",
        default=None,
        default_text="1e9 Pa, for contact bonds 1e9 N",
    )
    unbalanced_limit: float = key(
        Number(POSITIVE),
        "Largest unbalanced force of a specimen at rest, over the mean contact force.",
        default=0.005,
    )
    damping: float = key(
        Number(Interval(least=0, below=1)), "Coefficient of YADE's local damping.", default=0.4
    )
    time_step_safety: float = key(
        Number(Interval(above=0, most=1)), "Time step over the critical one.", default=0.8
    )

    @staticmethod
    def problems(section: Any) -> Iterator[Problem]:
        normal, wall = section.normal_stiffness, section.wall_stiffness
        if normal is not None and wall is not None and normal.unit != wall.unit:
            reason = f"not given in the same way as normal_stiffness [{normal.unit}]"
            yield Problem(reason, f"a stiffness in {normal.unit}", "wall_stiffness")
