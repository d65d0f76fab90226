"""The grading plot shows the curves it was given."""

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from grus.errors import GrusError
from grus.grading import Grading, power_law_grading
from grus.plotting.grading import grading_plot

BEFORE = power_law_grading(9.5e-3, 19.1e-3, -0.5, points=8)


def stages(count):
    return {"before": BEFORE} | {
        f"{100 * i} kPa": power_law_grading(9.5e-3 / (1 + i), 19.1e-3, 1.0, points=8)
        for i in range(1, count)
    }


def labels(figure):
    return [text.get_text() for text in figure.legends[0].get_texts()]


@pytest.mark.parametrize("count", [2, 5])
def test_curves_and_changes(count):
    gradings = stages(count)
    figure = grading_plot(gradings, title="Oedometer")
    upper, lower = figure.axes
    for line, grading in zip(upper.get_lines(), gradings.values()):
        assert line.get_xdata() == pytest.approx(1e3 * grading.sizes)
        assert line.get_ydata() == pytest.approx(grading.passing)
    changes = lower.get_lines()[: count - 1]
    for line, grading in zip(changes, list(gradings.values())[1:]):
        sizes = 1e-3 * line.get_xdata()
        expected = grading.passing_at(sizes) - BEFORE.passing_at(sizes)
        assert line.get_ydata() == pytest.approx(expected)
    assert (
        len(
            {
                line.get_color() if isinstance(line.get_color(), str) else tuple(line.get_color())
                for line in upper.get_lines()[:count]
            }
        )
        == count
    )
    assert [label.split(":")[0] for label in labels(figure)[:-1]] == list(gradings)


def test_key_and_panels_do_not_overlap():
    figure = grading_plot(stages(6))
    renderer = FigureCanvasAgg(figure).get_renderer()
    figure.draw(renderer)
    key = figure.legends[0].get_window_extent(renderer)
    upper, lower = (axes.get_tightbbox(renderer) for axes in figure.axes)
    assert key.y0 >= -1 and key.y1 <= lower.y0 + 1 and lower.y1 <= upper.y0 + 1
    assert upper.x0 >= -1 and upper.x1 <= figure.bbox.width + 1


def test_one_grading_has_one_panel():
    assert len(grading_plot({"target": BEFORE}).axes) == 1


def test_curve_with_fines_that_no_sieve_told_apart():
    figure = grading_plot({"a": Grading([1e-3, 2e-3, 4e-3], [15, 60, 100]), "b": BEFORE})
    assert np.isfinite(figure.axes[1].get_lines()[0].get_ydata()).all()
    assert "D_{50}" in labels(figure)[0] and "D_{10}" not in labels(figure)[0]


def test_no_grading_is_refused():
    with pytest.raises(
        GrusError, match="^gradings: none given; a grading plot needs at least one$"
    ):
        grading_plot({})
