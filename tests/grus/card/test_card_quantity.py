"""Numbers with units."""

import copy
import pickle

import pytest
from hypothesis import given
from hypothesis import strategies as st

from grus.card.errors import Problem
from grus.card.interval import NOT_NEGATIVE, POSITIVE, Interval
from grus.card.quantity import Measure, Quantity

LENGTH = Quantity({"m": "a length"}, POSITIVE, "1 mm")
STIFFNESS = Quantity(
    {"N/m": "a stiffness", "Pa/m": "a stiffness per area", "Pa": "a modulus"}, POSITIVE, "1 N/m"
)
ANGLE = Quantity({"rad": "an angle"}, NOT_NEGATIVE, "30 deg")


@pytest.mark.parametrize(
    "written, metres",
    [
        ("12.6 mm", 0.0126),
        ("12.6mm", 0.0126),
        (" 1.26e1  mm ", 0.0126),
        ("+.0126 m", 0.0126),
        ("12600 um", 0.0126),
        ("12600 µm", 0.0126),
        ("12600 \N{GREEK SMALL LETTER MU}m", 0.0126),
        ("12600 micrometer", 0.0126),
        ("1 in", 0.0254),
        ("0.1 cm", 0.001),
        ("0.3 mm", 0.0003),
        ("1e-300 m", 1e-300),
        ("1 m\n", 1.0),
        ("1 m^2/m", 1.0),
        ("2 m**2 / m", 2.0),
        ("5 mm s/s", 0.005),
    ],
)
def test_lengths_are_exact(written, metres):
    assert LENGTH.read(written) == metres


@pytest.mark.parametrize(
    "written, value, unit",
    [
        ("3e9 N/m", 3e9, "N/m"),
        ("3 kN/mm", 3e6, "N/m"),
        ("3 GPa m", 3e9, "N/m"),
        ("3 MPa/mm", 3e9, "Pa/m"),
        ("3 N/m³", 3.0, "Pa/m"),
        ("3 GPa", 3e9, "Pa"),
        ("3 N/mm²", 3e6, "Pa"),
        ("3 kg/m/s^2", 3.0, "Pa"),
    ],
)
def test_unit_tells_the_kind(written, value, unit):
    read = STIFFNESS.read(written)
    assert read == value and read.unit == unit


@pytest.mark.parametrize("unit", ["deg", "degree", "degrees", "°"])
def test_angles(unit):
    assert ANGLE.read(f"180 {unit}") == pytest.approx(3.141592653589793, rel=1e-15)


@pytest.mark.parametrize(
    "written",
    ["", " ", "m", "12.6", "mm 12.6", "12,6 mm", "1.2.3 m", "1 2 m", "1e m", "--1 m", "0x10 m"]
    + ["1 kg", "1 degC", "1 m^2", "1 s", "1 furlongs_per", "1 m3", "1 m/", "1 (m)", "1 m; 2", "1 %"]
    + ["nan m", "inf m", "1e999 m", "1e999999999999999999999 m", "1e-999 m", "0 m", "-0 m", "-1 m"]
    + [
        "1 m**9**9**9",
        "1 km**99999999",
        "9**9**9 m",
        "1 m\n2",
        "1 m\0",
        "1 dB",
        "1 __class__",
        "1 e",
    ]
    + ["1 " + "m " * 50, "1" * 1000 + " m", "１ m", "1 m²²", "1 rad m"],
)
def test_refused(written):
    with pytest.raises(Problem):
        LENGTH.read(written)


@pytest.mark.parametrize("value", [1, 1.5, 0, True, None, [], {}, float("nan"), 10**400, b"1 m"])
def test_only_text_is_read(value):
    with pytest.raises(Problem):
        LENGTH.read(value)


def test_plain_number_is_asked_for_its_unit():
    for value in (12.6, "12.6"):
        with pytest.raises(Problem) as caught:
            LENGTH.read(value)
        assert caught.value.reason == 'give a unit, for example "1 mm"'


def test_turns_are_no_angles_without_a_unit_of_angle():
    for written in ("1 count", "1 m/m", "0.5"):
        with pytest.raises(Problem):
            ANGLE.read(written)


@given(st.floats(min_value=1e-250, max_value=1e250))
def test_a_measure_reads_what_it_writes(value):
    measure = Measure(value, "Pa/m")
    again = STIFFNESS.read(measure.written())
    assert again == value and again.unit == measure.unit


@given(st.decimals(min_value="0.000001", max_value="1e6", places=6))
def test_millimetres_and_metres_agree_to_the_last_bit(value):
    assert LENGTH.read(f"{value} mm") == LENGTH.read(f"{value.scaleb(-3)} m")


def test_measure_keeps_its_unit_in_copies():
    measure = Measure(1.5, "N/m")
    for other in (copy.copy(measure), copy.deepcopy(measure), pickle.loads(pickle.dumps(measure))):
        assert other == 1.5 and other.unit == "N/m"


@pytest.mark.parametrize(
    "interval, inside, outside, text",
    [
        (Interval(above=0), [1e-300, 1], [0, -1], "> 0"),
        (Interval(least=0, below=1), [0, 0.5], [1, -1e-9], ">= 0 and < 1"),
        (Interval(above=0, most=1), [1], [0, 1.1], "> 0 and <= 1"),
    ],
)
def test_interval(interval, inside, outside, text):
    assert all(x in interval for x in inside) and not any(x in interval for x in outside)
    assert interval.text() == text
