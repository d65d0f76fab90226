"""The style and the writing of figures."""

import matplotlib
import pytest
from matplotlib.image import imread

from grus.plotting import draw_key, new_figure, save, style
from grus.plotting.style import PALETTE


def small_figure():
    with style():
        figure, axes = new_figure(size=(2.0, 1.5), key_rows=1)
        (line,) = axes.plot([0, 1], [0, 1])
        axes.set_xlabel("Axial strain [%]")
        draw_key(figure, [line], ["oedometer"])
    return figure


def test_png_and_svg_are_written(tmp_path):
    png, svg = save(small_figure(), tmp_path / "new" / "curve_d_9.5mm")
    assert png.name == "curve_d_9.5mm.png"
    assert svg.name == "curve_d_9.5mm.svg"
    assert sorted(path.name for path in png.parent.iterdir()) == [png.name, svg.name]
    height, width = imread(png).shape[:2]
    assert width == 400  # 2 inches at 200 dpi
    assert height > 300  # 1.5 inches and the key


def test_the_same_figure_gives_the_same_bytes(tmp_path):
    first = [path.read_bytes() for path in save(small_figure(), tmp_path / "a")]
    second = [path.read_bytes() for path in save(small_figure(), str(tmp_path / "b"))]
    assert first == second
    assert b"<dc:date>" not in first[1]


def test_a_failed_write_leaves_the_old_file(tmp_path, monkeypatch):
    png, _ = save(small_figure(), tmp_path / "a")
    before = png.read_bytes()
    figure = small_figure()

    def fail(target, **_):
        target.write_bytes(b"half")
        raise OSError("disk full")

    monkeypatch.setattr(figure, "savefig", fail)
    with pytest.raises(OSError, match="disk full"):
        save(figure, tmp_path / "a")
    assert png.read_bytes() == before
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.png", "a.svg"]


def test_style_overrides_the_user_and_leaves_no_trace():
    with matplotlib.rc_context({"font.size": 30, "axes.facecolor": "red"}):
        with style():
            assert matplotlib.rcParams["font.size"] < 12
            assert matplotlib.rcParams["axes.facecolor"] == "white"
        assert matplotlib.rcParams["font.size"] == 30


def test_palette_is_distinct():
    assert len(set(PALETTE)) == len(PALETTE)


def test_key_lies_below_the_axes():
    figure = small_figure()
    figure.draw_without_rendering()
    canvas = figure.canvas.get_renderer() if hasattr(figure.canvas, "get_renderer") else None
    key = figure.legends[0].get_window_extent(canvas)
    axes = figure.axes[0].get_tightbbox(canvas)
    assert key.y1 <= axes.y0
