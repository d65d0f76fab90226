"""[agglomerate]: outline of a grain and how the stamp divides it into clumps."""

from collections.abc import Iterator
from typing import Any, Literal

from grus.card.errors import Problem
from grus.card.interval import NOT_NEGATIVE, POSITIVE, Interval
from grus.card.polygon import Vertices
from grus.card.presence import must_be_absent, must_be_given
from grus.card.pydantic_adapter import Section, key
from grus.card.quantity import Measure, Quantity
from grus.card.values import Choice, Flag, Number, Text

OUTLINES = {2: ("circle", "polygon"), 3: ("sphere", "mesh")}
MESHES = (".stl", ".gts")
LENGTH = {"m": "a length"}


class Agglomerate(Section):
    """A grain cut out of a hexagonal close packing of elements."""

    outline: Literal["circle", "polygon", "sphere", "mesh"] = key(
        Choice(("circle", "polygon", "sphere", "mesh")),
        "Shape of a grain: circle or polygon in the plane, sphere or mesh in space.",
    )
    diameter: Measure = key(
        Quantity(LENGTH, POSITIVE, "12.6 mm"),
        "Diameter; a polygon or mesh is scaled to the circle or sphere of equal area or volume.",
    )
    vertices: tuple | None = key(
        Vertices(),
        "Corners of a polygon in order; only the shape counts.",
        default=None,
        default_text="needed for outline polygon",
    )
    mesh: str | None = key(
        Text("path of a file *.stl or *.gts", 400),
        "Closed surface in STL or GTS format; a relative path counts from the folder of the card. "
        "Only the shape counts.",
        default=None,
        default_text="needed for outline mesh",
    )
    stamp_radius: Measure | None = key(
        Quantity(LENGTH, POSITIVE, "1.0 mm"),
        "Mean radius of the stamp that makes clumps of elements (Cho, Martin & Sego 2007).",
        default=None,
        default_text="none: no stamp, every element by itself",
    )
    stamp_deviation: Measure = key(
        Quantity(LENGTH, NOT_NEGATIVE, "0.2 mm"),
        "Standard deviation of the stamp radius.",
        default="0 mm",
    )
    leftover: Literal["single", "merge"] = key(
        Choice(("single", "merge")),
        "Elements caught alone, or by no stamp: left single, or merged into a neighbouring clump.",
        default="single",
    )
    stamp_share: float = key(
        Number(Interval(above=0, most=1)),
        "Share of the elements in clumps at which stamping ends.",
        default=1,
    )
    stamp_split: bool = key(
        Flag(), "Whether a clump that is not in one piece is split into its pieces.", default=False
    )
    missing_fraction: float = key(
        Number(Interval(least=0, below=1)),
        "Share of the elements taken out at random (McDowell & Harireche 2002).",
        default=0,
    )
    random_orientation: bool = key(
        Flag(), "Whether the packing is turned at random in each grain.", default=True
    )

    @staticmethod
    def problems(section: Any) -> Iterator[Problem]:
        shapes = {"polygon": "vertices", "mesh": "mesh"}
        for outline, name in shapes.items():
            check = must_be_given if section.outline == outline else must_be_absent
            yield from check(section, [name], f"outline {section.outline}")
        if section.mesh is not None and not section.mesh.lower().endswith(MESHES):
            yield Problem("not a mesh by its name", "a file *.stl or *.gts", "mesh")
        yield from _stamp(section)


def _stamp(section: Any) -> Iterator[Problem]:
    if section.stamp_radius is None:
        if section.stamp_deviation != 0:
            yield Problem("has no use without stamp_radius", "leave the key out", "stamp_deviation")
        return
    if section.stamp_radius >= section.diameter / 2:
        yield Problem(
            "the stamp covers the whole grain", "less than half of diameter", "stamp_radius"
        )
    if section.stamp_deviation >= section.stamp_radius:
        yield Problem("as large as the mean", "less than stamp_radius", "stamp_deviation")
