"""The plot of a recording shows its readings and its segments."""

from dataclasses import replace

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from test_segments import record

from grus.errors import GrusError
from grus.plotting.recording import COLOURS, recording_plot
from grus.record import KINDS, Record
from grus.recording import segments


def staged(time=None):
    stress = 1e3 * np.repeat([5.0, 100.0, 200.0, 50.0, 200.0], 12)
    whole = record(stress, time=time)
    return replace(whole, segments=segments(whole))


@pytest.mark.parametrize(
    "time, label",
    [
        (None, "Reading"),
        (np.arange(60), "Time [s]"),
        (60 * np.arange(60), "Time [min]"),
        (3600 * np.arange(60), "Time [d]"),
    ],
)
def test_readings_and_segments(time, label):
    figure = recording_plot(staged(time), "a test")
    stress, strain, curve = figure.axes
    assert stress.get_lines()[0].get_ydata() == pytest.approx(
        np.repeat([5.0, 100.0, 200.0, 50.0, 200.0], 12)
    )
    assert strain.get_xlabel() == label and "kPa" in stress.get_ylabel()
    assert strain.yaxis_inverted() and curve.yaxis_inverted()
    numbers = [text.get_text() for text in stress.texts]
    assert numbers == ["0", "2", "4", "6", "8"]
    shown = [text.get_text() for text in figure.legends[0].get_texts()]
    assert shown == ["seating", "loading", "reloading", "unloading", "hold"]
    renderer = FigureCanvasAgg(figure).get_renderer()
    figure.draw(renderer)
    drawn, (width, height) = figure.get_tightbbox(renderer), figure.get_size_inches()
    assert drawn.x0 >= -0.01 and drawn.y0 >= -0.01
    assert drawn.x1 <= width + 0.01 and drawn.y1 <= height + 0.01


def test_every_kind_has_its_colour():
    assert set(COLOURS) == set(KINDS) and len(set(COLOURS.values())) == len(KINDS)


def test_a_record_without_segments_is_drawn():
    figure = recording_plot(record([1e3, 2e3, 0.0, -10.0]))
    assert figure.legends[0].get_texts()[0].get_text() == "not cut into segments"


def test_a_record_without_strain_is_refused():
    with pytest.raises(GrusError, match="no readings of axial_strain"):
        recording_plot(Record({"axial_stress": np.ones(2)}, {"axial_stress": "Pa"}))
