"""The plots of compression and breakage show what they were given."""

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from grus.compression import breakage_onset, first_loading, yield_stress
from grus.errors import GrusError
from grus.plotting.compression import breakage_plot, compression_plot


def path():
    """Stress with a loop and a last unloading, void ratio, broken bonds."""
    stress = np.concatenate(
        [
            np.geomspace(5e3, 3e5, 60),
            np.geomspace(3e5, 3e4, 15),
            np.geomspace(3e4, 1e6, 80),
            np.geomspace(1e6, 1e5, 15),
        ]
    )
    highest = np.maximum.accumulate(stress)
    past = np.maximum(np.log10(highest / 4e5), 0)
    value = (
        0.25 - 0.001 * np.log10(highest / 5e3) - 0.01 * past + 0.0005 * np.log10(highest / stress)
    )
    return stress, value, np.round(300 * past)


def labels(figure):
    return [text.get_text() for text in figure.legends[0].get_texts()]


def check_layout(figure):
    renderer = FigureCanvasAgg(figure).get_renderer()
    figure.draw(renderer)
    key = figure.legends[0].get_window_extent(renderer)
    axes = figure.axes[0].get_tightbbox(renderer)
    assert key.y0 >= -1 and key.y1 <= axes.y0 + 1
    assert key.x0 >= -1 and key.x1 <= figure.bbox.width + 1
    assert axes.x0 >= -1 and axes.x1 <= figure.bbox.width + 1


@pytest.mark.parametrize("normalised", [False, True])
def test_compression_curve(normalised):
    stress, value, _ = path()
    found = yield_stress(stress, value)
    figure = compression_plot({"test": (stress, value)}, {"test": found}, normalised, "Title")
    axes = figure.axes[0]
    scale = 1 / value[0] if normalised else 1.0
    whole, strong, mark = axes.get_lines()[:3]
    assert whole.get_ydata() == pytest.approx(scale * value)
    assert strong.get_xdata() == pytest.approx(1e-3 * stress[first_loading(stress)])
    assert mark.get_xdata() == pytest.approx([1e-3 * found.stress])
    assert mark.get_ydata() == pytest.approx([scale * found.void_ratio])
    before, after = axes.get_lines()[3:5]
    assert np.interp(1e-3 * found.stress, before.get_xdata(), before.get_ydata()) == pytest.approx(
        np.interp(1e-3 * found.stress, after.get_xdata(), after.get_ydata()), abs=2e-3 * scale
    )
    assert labels(figure)[0].startswith("test:  yield 400 kPa (95 %: ")
    assert axes.get_xlabel() == r"Axial stress $\sigma$ [kPa]"
    check_layout(figure)


def test_tests_without_yield():
    stress, value, _ = path()
    curves = {"a": (10 * stress, value), "b": (stress, value)}
    figure = compression_plot(curves, {"a": None})
    assert labels(figure) == ["a", "b"]
    assert figure.axes[0].get_xlabel() == r"Axial stress $\sigma$ [MPa]"
    check_layout(figure)


def test_breakage():
    stress, _, broken = path()
    curves = {"a": (stress, broken), "b": (stress, 0 * broken)}
    onsets = {name: breakage_onset(*curve) for name, curve in curves.items()}
    figure = breakage_plot(curves, onsets)
    assert labels(figure)[0].startswith("a:  onset ")
    assert "first breakage" in labels(figure)[0]
    assert labels(figure)[1] == "b:  no onset"
    assert figure.axes[0].get_lines()[0].get_ydata() == pytest.approx(broken)
    assert figure.axes[0].get_ylabel() == "Bonds broken"
    check_layout(figure)


def test_readings_at_no_stress_are_left_out():
    stress, value, _ = path()
    figure = compression_plot({"a": (np.r_[0.0, stress], np.r_[0.9, value])})
    assert figure.axes[0].get_lines()[0].get_ydata() == pytest.approx(value)


@pytest.mark.parametrize(
    "curves, yields, message",
    [
        ({}, None, "curves: none given; a plot needs at least one"),
        ({"a": ([1.0], [1.0])}, {"b": None}, "marks: 'b' is no curve; must be one of a"),
        (
            {"a": ([1.0, 2.0], [1.0])},
            None,
            "curves: 'a' has columns of shapes (2,) and (1,); must be of one length",
        ),
        (
            {"a": ([0.0], [1.0])},
            None,
            "curves: 'a' has no stress above zero; must have one at least",
        ),
    ],
)
def test_refusals(curves, yields, message):
    with pytest.raises(GrusError) as refusal:
        compression_plot(curves, yields)
    assert str(refusal.value) == message
