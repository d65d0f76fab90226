import numpy as np
import pytest
from matplotlib.collections import EllipseCollection, LineCollection
from matplotlib.figure import Figure

from grus.errors import GrusError
from grus.specimen import Circle, Sphere, Stamp, agglomerate, draw
from grus.specimen.draw import clump_colours
from grus.specimen.touching import touching_pairs

STAMP = Stamp(mean=1.0e-3, deviation=0.2e-3)


def collections(axes, kind):
    return [c for c in axes.collections if type(c) is kind]


def test_plane_specimen_shows_discs_and_bonds():
    specimen = agglomerate(Circle(12.6e-3), 0.6e-3, stamp=STAMP, seed=1)
    axes = draw(specimen, bonds=True)
    for discs in collections(axes, EllipseCollection):
        np.testing.assert_allclose(discs.get_offsets(), 1e3 * specimen.position[:, :2])
    stitches = collections(axes, LineCollection)[0]
    assert len(stitches.get_segments()) == len(specimen.bonds())
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    x, y = 1e3 * specimen.position[:, :2].T
    assert left < x.min() - 0.6 and x.max() + 0.6 < right
    assert low < y.min() - 0.6 and y.max() + 0.6 < high
    axes.figure.canvas.draw()


def test_space_specimen_is_drawn_from_back_to_front():
    specimen = agglomerate(Sphere(6e-3), 0.6e-3, stamp=STAMP, seed=1)
    axes = draw(specimen, view=(0.0, 0.0))  # seen along -x: right is y, up is z
    seen = collections(axes, EllipseCollection)[0].get_offsets()
    order = np.argsort(specimen.position[:, 0], kind="stable")
    rims = seen[:: len(seen) // specimen.element_count]
    np.testing.assert_allclose(rims, 1e3 * specimen.position[order, 1:], atol=1e-12)
    axes.figure.canvas.draw()


def test_clumps_that_touch_differ_in_colour():
    specimen = agglomerate(Circle(30e-3), 0.6e-3, stamp=STAMP, seed=2)
    pairs = touching_pairs(specimen.position, specimen.radius)
    colour = clump_colours(specimen, pairs)
    first, second = specimen.clump[pairs].T
    apart = first != second
    assert (colour[first[apart]] != colour[second[apart]]).all()


def test_given_axes_are_used():
    axes = Figure().add_subplot()
    assert draw(agglomerate(Circle(5e-3), 0.6e-3, seed=0), axes) is axes


def test_bonds_in_space_are_refused():
    with pytest.raises(GrusError, match="bonds = True: must be False for a specimen in space"):
        draw(agglomerate(Sphere(5e-3), 0.6e-3, seed=0), bonds=True)
