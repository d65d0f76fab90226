"""Grain sizes, exo-spheres and rigid motion."""

import numpy as np
import pytest

from grus.errors import GrusError
from grus.preparation import PreparedSpecimen, make
from grus.preparation.diameters import diameters, grading
from grus.preparation.exo import grow, place
from grus.preparation.grain import sized_grain
from grus.preparation.rigid import fit_rigid
from grus.preparation.stream import Step, stream
from grus.preparation.width import directions, mean_width, outline_mean_width
from grus.specimen import Polygon, join
from grus.specimen.rotation import plane_rotation, random_rotation


@pytest.mark.parametrize("dimension", [2, 3])
def test_mean_width_of_a_rod(dimension):
    # Of a segment of length L: 2 L / pi in the plane, L / 2 in space.
    ends = np.array([[0.0, 0, 0], [3.0, 0, 0]])
    wanted = 0.2 + {2: 6 / np.pi, 3: 1.5}[dimension]
    assert mean_width(ends, 0.1, dimension) == pytest.approx(wanted, rel=2e-3)
    assert np.linalg.norm(directions(dimension), axis=1) == pytest.approx(1)


def test_mean_width_of_a_polygon_is_its_perimeter_over_pi():
    square = Polygon(np.array([[0, 0], [2, 0], [2, 2], [0, 2]]))
    assert outline_mean_width(square) == pytest.approx(8 / np.pi, rel=1e-4)


def test_grains_measure_their_diameters(plane, solid):
    for card in (plane, solid):
        wide = [
            mean_width(sized_grain(card, i, 12e-3).position, card.element.radius, card.dimension)
            for i in range(20)
        ]
        assert np.mean(wide) == pytest.approx(12e-3, rel=0.01)
        assert np.ptp(wide) < card.element.radius  # grains end at whole elements


def test_number_of_grains_follows_from_the_box(plane):
    sizes = diameters(plane)
    assert len(sizes) == 40
    assert sizes.min() >= plane.specimen.minimum_diameter
    assert sizes.max() <= plane.specimen.maximum_diameter
    assert np.sqrt((sizes**2).mean()) == pytest.approx(12.6e-3, rel=0.01)
    assert len(diameters(plane.with_overrides({"specimen.grains": 39}))) == 39


def test_the_paper_has_1520_grains(plane):
    big = {"specimen.width": "0.500 m", "specimen.height": "0.474 m"}
    assert len(diameters(plane.with_overrides(big))) == pytest.approx(1520, abs=3)


def test_a_table_of_sieves(plane):
    table = {"sieve": ["10 mm", "12 mm", "16 mm"], "passing": [0, 25, 100]}
    changed = {f"specimen.{name}": value for name, value in table.items()}
    changed |= {f"specimen.{n}_diameter": None for n in ("minimum", "maximum", "rms")}
    card = plane.with_overrides(changed)
    assert grading(card).passing_at(12e-3) == pytest.approx(25)
    sizes = diameters(card)
    assert (sizes[sizes < 12e-3] ** 2).sum() / (sizes**2).sum() == pytest.approx(0.25, abs=0.05)


def test_exo_spheres_end_apart_and_inside(plane):
    radius = np.linspace(5e-3, 8e-3, 12)
    size = np.array([0.05, np.pi * (radius**2).sum() / 0.6 / 0.05])
    start = plane.preparation.start_factor
    centre = grow(plane, place(start * radius, size, stream(1, Step.PLACES)), radius, size)
    apart = np.linalg.norm(centre[:, None] - centre[None], axis=2) + 1e3 * np.eye(12)
    assert (apart - radius[:, None] - radius).min() > -0.01 * plane.element.radius
    assert (centre[:, :2] > 0.98 * radius[:, None]).all()


def test_no_place_is_told():
    assert place(np.array([1.0, 1.0]), np.array([2.5, 2.5]), stream(1, Step.PLACES)) is None


@pytest.mark.parametrize("name, rotation", [("plane", plane_rotation(2.0)), ("solid", None)])
def test_rigid_motion_is_recovered(request, name, rotation):
    card = request.getfixturevalue(name)
    if rotation is None:
        rotation = random_rotation(stream(3, Step.PLACES))
    grains = [sized_grain(card, i, 12e-3) for i in range(2)]
    shift = np.array([[0.1, 0.2, 0.0], [0.3, 0.1, 0.0]])
    both = join(grains, 0 * shift)
    moved = both.position @ rotation.T + shift[both.grain]
    # Places are rounded to a grid of up to 2^-25 of a radius, see `on_grid`.
    grid = card.element.radius * 2.0**-25
    np.testing.assert_allclose(fit_rigid(both, moved), moved, rtol=0, atol=grid)


@pytest.mark.parametrize(
    "change, words",
    [
        ({"specimen.grains": 60}, ("specimen.grains = 60", "about 40")),
        (
            {"specimen.width": "39 mm", "specimen.height": "39 mm", "specimen.void_ratio": 2.8},
            ("the box holds 3 grains", "4 or more"),
        ),
        (
            {"preparation.start_factor": 0.99, "preparation.exo_solid_fraction": 0.9},
            ("exo_solid_fraction = 0.9", "find no place"),
        ),
        (
            {"specimen.void_ratio": 0.9, "preparation.attempts": 1},
            ("specimen.void_ratio = 0.9: not reached in 1 packing", "allowed: "),
        ),
        ({"specimen": None, "preparation": None}, ("specimen is missing",)),
    ],
)
def test_what_cannot_be_made_is_refused_in_one_line(plane, change, words):
    with pytest.raises(GrusError) as caught:
        make(plane.with_overrides(change))
    message = str(caught.value)
    assert len(message.splitlines()) == 1 and all(word in message for word in words)


def test_other_files_are_refused(tmp_path):
    with pytest.raises(FileNotFoundError):
        PreparedSpecimen.load(tmp_path / "none.h5")
    (tmp_path / "text.h5").write_text("nothing")
    with pytest.raises(GrusError, match="text.h5"):
        PreparedSpecimen.load(tmp_path / "text.h5")
