"""The plots show the numbers that they were given, and refuse what cannot be drawn."""

import itertools

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from grus.errors import GrusError
from grus.plotting import force_displacement_plot, size_effect_plot, weibull_plot
from grus.plotting.labels import (
    interval,
    log_ticks,
    prefixed,
    probability,
    significant,
    survival_ticks,
)
from grus.statistics import fit_weibull, size_effect


def strengths(seed, n, modulus=3.0, sigma0=12e6):
    uniform = np.random.Generator(np.random.PCG64(seed)).random(n)
    return sigma0 * (-np.log1p(-uniform)) ** (1.0 / modulus)


def texts(figure):
    found = [text.get_text() for axes in figure.axes for text in axes.texts]
    legends = figure.legends + [axes.get_legend() for axes in figure.axes if axes.get_legend()]
    return "\n".join(found + [text.get_text() for key in legends for text in key.get_texts()])


def check_layout(figure):
    """Nothing drawn reaches beyond the paper, and no tick label, text or key covers another."""
    renderer = FigureCanvasAgg(figure).get_renderer()
    figure.draw(renderer)
    drawn = figure.get_tightbbox(renderer)
    width, height = figure.get_size_inches()
    assert drawn.x0 >= -0.01 and drawn.y0 >= -0.01
    assert drawn.x1 <= width + 0.01 and drawn.y1 <= height + 0.01
    axes = figure.axes[0]
    parts = [*axes.texts, axes.xaxis.label, axes.yaxis.label, *figure.legends]
    parts += [axes.get_legend()] if axes.get_legend() else []
    for axis in (axes.xaxis, axes.yaxis):
        low, high = sorted(axis.get_view_interval())
        parts += [t.label1 for t in axis.get_major_ticks() if low <= t.get_loc() <= high]
    boxes = [part.get_window_extent(renderer) for part in parts]
    for first, second in itertools.combinations(boxes, 2):
        assert not first.overlaps(second)


@pytest.mark.parametrize("n, modulus", [(3, 3.0), (30, 3.0), (30, 40.0), (3000, 1.0)])
def test_weibull_plot_of_one_group(n, modulus):
    fit = fit_weibull(strengths(1, n, modulus))
    figure = weibull_plot(fit, "Crushing strength")
    axes = figure.axes[0]
    points, line, _ = axes.get_lines()
    assert points.get_xdata() == pytest.approx(np.log(np.sort(fit.strengths) / 1e6))
    assert np.all(np.diff(points.get_ydata()) > 0)
    slope = np.diff(line.get_ydata()) / np.diff(line.get_xdata())
    assert slope == pytest.approx(fit.modulus)
    left, right = axes.get_xlim()
    assert left < points.get_xdata().min() and points.get_xdata().max() < right
    shown = texts(figure)
    assert f"$n$ = {n}" in shown
    assert significant(fit.modulus) in shown
    assert significant(fit.sigma0 / 1e6) in shown
    check_layout(figure)


def test_weibull_plot_of_a_censored_group():
    values = strengths(2, 40)
    fit = fit_weibull(np.minimum(values, 13e6), censored=values > 13e6)
    figure = weibull_plot(fit)
    assert f"{fit.n} ({fit.broken} broken)" in texts(figure)
    assert "unbroken" in texts(figure)
    assert "$p$" not in texts(figure)


def test_weibull_plot_of_several_groups():
    fits = {f"{d} mm": fit_weibull(strengths(d, 20, 3.0, 1e8 / d)) for d in (10, 14, 20)}
    figure = weibull_plot(fits)
    shown = texts(figure)
    assert all(f"{name}:" in shown for name in fits)
    lines = figure.axes[0].get_lines()[1::2]
    assert len({line.get_color() for line in lines[:3]}) == 3
    check_layout(figure)


def test_band_holds_the_line():
    fit = fit_weibull(strengths(3, 10))
    axes = weibull_plot(fit).axes[0]
    line = axes.get_lines()[1]
    edge = axes.collections[0].get_paths()[0].vertices
    for x, y in zip(line.get_xdata(), line.get_ydata()):
        beside = edge[np.isclose(edge[:, 1], y)][:, 0]
        assert beside.min() < x < beside.max()


def test_size_effect_plot():
    diameters = (0.010, 0.014, 0.020)
    groups = [strengths(10 + i, 20, 3.0, 12e4 / d) for i, d in enumerate(diameters)]
    effect = size_effect(diameters, groups, 3)
    figure = size_effect_plot(effect, "Size effect")
    axes = figure.axes[0]
    fitted, expected = [
        next(line for line in axes.get_lines() if str(line.get_label()).startswith(name))
        for name in ("fitted", "expected")
    ]
    for line, slope in ((fitted, effect.slope), (expected, effect.expected_slope)):
        steps = np.diff(np.log(line.get_ydata())) / np.diff(np.log(line.get_xdata()))
        assert steps == pytest.approx(slope)
    shown = texts(figure)
    assert significant(effect.slope) in shown
    assert significant(effect.expected_slope) in shown
    assert probability(effect.agreement_p_value) in shown
    check_layout(figure)


def curves(count):
    displacement = np.linspace(0.0, 4e-4, 50)
    rows = [2e7 * (index + 1) * displacement for index in range(count)]
    for index, force in enumerate(rows):
        force[30 + index :] *= 0.2
    return [(displacement, force) for force in rows]


def test_force_displacement_plot():
    paths = curves(4)
    figure = force_displacement_plot(paths, highlight=2, title="Group")
    axes = figure.axes[0]
    assert axes.get_xlabel() == "Platen displacement [µm]"
    assert axes.get_ylabel() == "Platen force [kN]"
    peak = axes.get_lines()[-1]
    at, force = paths[2][0][31], paths[2][1][31]
    assert peak.get_xdata() == pytest.approx([1e6 * at])
    assert peak.get_ydata() == pytest.approx([1e-3 * force])
    assert f"{significant(1e-3 * force)} kN" in texts(figure)
    assert "other grains (3)" in texts(figure)
    check_layout(figure)


def test_force_displacement_plot_takes_given_peaks():
    figure = force_displacement_plot(curves(1), peaks=[(1e-4, 2000.0)])
    assert figure.axes[0].get_lines()[-1].get_ydata() == pytest.approx([2.0])
    assert "other" not in texts(figure)


@pytest.mark.parametrize(
    "arguments, message",
    [
        (([],), "curves: none given; a force-displacement plot needs at least one"),
        ((curves(2), None, 2), "highlight: 2; must lie in 0..1"),
        (
            (curves(2), [(0.0, 1.0)]),
            "peaks: shape (1, 2); must be (displacement, force) for each curve",
        ),
        (
            ([([0.0, 1.0], [0.0])],),
            "curves: curve 0 has columns of shapes [(2,), (1,)]; "
            "must be displacement and force of one length",
        ),
        (([([], [])],), "curves: curve 0 is empty; must have at least one reading"),
    ],
)
def test_refused_curves(arguments, message):
    with pytest.raises(GrusError) as refusal:
        force_displacement_plot(*arguments)
    assert str(refusal.value) == message


def test_refused_fits():
    with pytest.raises(GrusError, match="^fits: none given"):
        weibull_plot({})
    mixed = {"a": fit_weibull([1, 2, 3]), "b": fit_weibull([1, 2, 3], confidence=0.9)}
    with pytest.raises(GrusError, match=r"^fits: confidences \[90.0, 95.0\] %; must be the same"):
        weibull_plot(mixed)


@pytest.mark.parametrize(
    "value, text",
    [
        (2.5, "2.50"),
        (0.9996, "1.00"),
        (1234.5, "1230"),
        (-0.0123, "\N{MINUS SIGN}0.0123"),
        (3.2e7, "3.20e+07"),
        (0.0, "0"),
        (float("inf"), "inf"),
    ],
)
def test_significant_digits(value, text):
    assert significant(value) == text


def test_intervals_probabilities_and_prefixes():
    assert interval(-1.5, 2.0) == "\N{MINUS SIGN}1.50 to 2.00"
    assert probability(0.2512) == "$p$ = 0.25"
    assert probability(1e-9) == "$p$ < 0.001"
    assert prefixed(2.3e4, "N") == (pytest.approx(1e-3), "kN")
    assert prefixed(1.0, "N") == (1.0, "N")
    assert prefixed(0.0, "N") == (1.0, "N")


@pytest.mark.parametrize("low, high", [(3.0, 25.0), (0.9, 1.06), (4e-4, 12.0), (1e-3, 1e9)])
def test_log_ticks_are_few_and_inside(low, high):
    ticks = log_ticks(low, high)
    assert 4 <= ticks.size <= 9
    assert low <= ticks.min() and ticks.max() <= high


def test_survival_ticks_are_readable():
    places, labels = survival_ticks(-9.2, 2.2)
    assert "37" in labels and "99" in labels
    assert np.diff(np.sort(places)).min() > 0.04 * 11.4
