"""Cards with a mistake: one line names the key, the value, what is wrong, what is allowed."""

import pytest

from grus.card import Card, CardError
from grus.errors import GrusError

NAN, INF = float("nan"), float("inf")
LONG = "x" * 100_000
PARALLEL = "bond.normal_stiffness"

MISTAKES = [
    # (overrides, the line after the file name, or its beginning)
    ({"element.radius": 0.6}, 'element.radius = 0.6: give a unit, for example "0.6 mm"; allowed'),
    ({"element.radius": "0.6"}, 'element.radius = "0.6": give a unit, for example'),
    (
        {"element.radius": "0,6 mm"},
        'element.radius = "0,6 mm": not a number (with a decimal point)',
    ),
    ({"element.radius": "0.6 mm3"}, 'element.radius = "0.6 mm3": "mm3" is not a unit'),
    ({"element.radius": "0.6 mmm"}, 'element.radius = "0.6 mmm": unknown unit "mmm"'),
    ({"element.radius": "0.6 kg"}, 'element.radius = "0.6 kg": "kg" (kilogram) is not a length'),
    ({"element.radius": "20 degC"}, 'element.radius = "20 degC": "degC" (degree_Celsius) is not'),
    (
        {"element.radius": "-1 mm"},
        'element.radius = "-1 mm": out of bounds; allowed: a length [m] > 0',
    ),
    ({"element.radius": "0 mm"}, 'element.radius = "0 mm": out of bounds'),
    ({"element.radius": "1e999 mm"}, 'element.radius = "1e999 mm": too large for a number'),
    ({"element.radius": "nan mm"}, 'element.radius = "nan mm": not a number'),
    ({"element.radius": ""}, 'element.radius = "": not a number'),
    ({"element.radius": LONG}, 'element.radius = "xxxxxxxx'),
    ({"element.radius": True}, "element.radius = true: not a number"),
    ({"element.radius": ["1 mm"]}, "element.radius = a list of 1 items: not a number"),
    ({"element.radius": {"value": 1}}, "element.radius = a table: not a number"),
    ({"element.radius": None}, "element.radius: is missing; allowed: a length [m] > 0"),
    (
        {"element.raduis": "1 mm"},
        'element.raduis = "1 mm": unknown key, did you mean element.radius;',
    ),
    (
        {"contact.moment_contribution": 1},
        "contact.moment_contribution = 1: unknown key, did you mean bond.moment",
    ),
    ({"zzz": 1}, "zzz = 1: unknown key; allowed: name, description"),
    ({LONG: 1}, "xxxxxxxx"),
    ({"element": None}, "element: is missing; allowed: a table with keys out of radius, density"),
    ({"element": 3}, "element = 3: not a table"),
    ({"element": [{"radius": "1 mm"}]}, "element = a list of 1 items: not a table"),
    ({"element.density": "-1 kg/m^3"}, 'element.density = "-1 kg/m^3": out of bounds'),
    ({"element.density": "2052 kg/m3"}, 'element.density = "2052 kg/m3": "kg/m3" is not a unit'),
    ({"name": None}, "name: is missing"),
    ({"name": ""}, 'name = "": empty, too long or not printable'),
    ({"name": 5}, "name = 5: not a text in quotes"),
    ({"name": "two\nlines"}, 'name = "two\\nlines": empty, too long or not printable'),
    ({"name": "\x1b[31m"}, 'name = "\\u001b[31m": empty'),
    ({"name": LONG}, 'name = "xxx'),
    ({"description": ["a"]}, "description = a list of 1 items: not a text"),
    ({"dimension": 4}, "dimension = 4: not one of the choices; allowed: 2 or 3"),
    ({"dimension": 2.0}, "dimension = 2.0: not one of the choices"),
    ({"dimension": "2"}, 'dimension = "2": not one of the choices'),
    ({"dimension": True}, "dimension = true: not one of the choices"),
    ({"dimension": 3, "thickness": None}, 'agglomerate.outline = "circle": not with dimension 3'),
    (
        {"dimension": 3, "agglomerate.outline": "sphere"},
        'thickness = "1 m": dimension 3 has no use',
    ),
    ({"thickness": 1}, 'thickness = 1: give a unit, for example "1 m"'),
    ({"seed": -1}, "seed = -1: out of bounds; allowed: a whole number from 0 to 2147483647"),
    ({"seed": 1.5}, "seed = 1.5: not a whole number"),
    ({"seed": True}, "seed = true: not a whole number"),
    ({"seed": 2**31}, "seed = 2147483648: out of bounds"),
    ({"seed": 16**10_000}, "seed = an integer of about 12042 digits: out of bounds"),
    ({"contact.friction_coefficient": -0.1}, "contact.friction_coefficient = -0.1: out of bounds"),
    (
        {"contact.friction_coefficient": NAN},
        "contact.friction_coefficient = nan: not a finite number",
    ),
    (
        {"contact.friction_coefficient": INF},
        "contact.friction_coefficient = inf: not a finite number",
    ),
    (
        {"contact.friction_coefficient": 10**400},
        "contact.friction_coefficient = an integer of about",
    ),
    (
        {"contact.friction_coefficient": "0.5"},
        'contact.friction_coefficient = "0.5": a plain number',
    ),
    ({"contact.friction_coefficient": False}, "contact.friction_coefficient = false: not a number"),
    ({"contact.normal_stiffness": "0 N/m"}, 'contact.normal_stiffness = "0 N/m": out of bounds'),
    (
        {"contact.shear_stiffness": "3 GPa"},
        'contact.shear_stiffness = "3 GPa": not given in the same',
    ),
    (
        {"contact.normal_stiffness": "3 Pa/m"},
        'contact.normal_stiffness = "3 Pa/m": "Pa/m" is not a',
    ),
    (
        {"bond.kind": "cement"},
        'bond.kind = "cement": not one of the choices; allowed: "parallel", ',
    ),
    ({"bond.kind": ["none"]}, "bond.kind = a list of 1 items: not one of the choices"),
    (
        {"bond.kind": "contact"},
        'bond.normal_stiffness = "3e9 N/m": a contact bond has no use for it',
    ),
    ({"bond.kind": "none"}, 'bond.normal_stiffness = "3e9 N/m": kind none has no use for it'),
    (
        {PARALLEL: None},
        "bond.normal_stiffness: is missing, a parallel bond needs it; allowed: a total",
    ),
    ({PARALLEL: "3 GPa"}, 'bond.shear_stiffness = "3e9 N/m": not given in the same way as normal_'),
    (
        {"bond.tensile_strength": "5 N"},
        'bond.tensile_strength = "5 N": a parallel bond needs a stress',
    ),
    ({"bond.tensile_strength": "1 pa"}, 'bond.tensile_strength = "1 pa": "pa" (picoyear) is not a'),
    (
        {"bond.radius_ratio": 0},
        "bond.radius_ratio = 0: out of bounds; allowed: a number > 0 and <= 1",
    ),
    ({"bond.radius_ratio": 1.01}, "bond.radius_ratio = 1.01: out of bounds"),
    ({"bond.moment_contribution": 2}, "bond.moment_contribution = 2: out of bounds"),
    ({"bond.friction_angle": 30}, 'bond.friction_angle = 30: give a unit, for example "30 deg"'),
    (
        {"bond.friction_angle": "90 deg"},
        'bond.friction_angle = "90 deg": out of bounds; allowed: an',
    ),
    ({"bond.scatter.kind": "gauss"}, 'bond.scatter.kind = "gauss": not one of the choices'),
    ({"bond.scatter.kind": "normal"}, "bond.scatter.coefficient_of_variation: is missing, scatter"),
    (
        {"bond.scatter.modulus": 3},
        "bond.scatter.modulus = 3: scatter of kind none has no use for it",
    ),
    ({"bond.scatter": "weibull"}, 'bond.scatter = "weibull": not a table'),
    ({"bond.grain_scatter": {}}, "bond.grain_scatter.modulus: is missing"),
    ({"bond.grain_scatter.modulus": 0}, "bond.grain_scatter.modulus = 0: out of bounds"),
    (
        {"agglomerate.outline": "polygon"},
        "agglomerate.vertices: is missing, outline polygon needs it",
    ),
    (
        {"agglomerate.vertices": [[0, 0], [1, 0], [0, 1]]},
        "agglomerate.vertices = a list of 3 items: o",
    ),
    (
        {"agglomerate": {"outline": "circle", "diameter": "2 mm"}},
        'agglomerate.diameter = "2 mm": only 1.67 elements across; al',
    ),
    (
        {"element.radius": "1 nm"},
        'element.radius = "1 nm": about 1e14 elements in a grain; allowed: at',
    ),
    (
        {"element.radius": "1e-300 m"},
        'element.radius = "1e-300 m": about 1e596 elements in a grain',
    ),
    (
        {"agglomerate.stamp_radius": "7 mm"},
        'agglomerate.stamp_radius = "7 mm": the stamp covers the',
    ),
    (
        {"agglomerate.stamp_radius": None},
        'agglomerate.stamp_deviation = "0.2 mm": has no use without',
    ),
    (
        {"agglomerate.stamp_deviation": "1 mm"},
        'agglomerate.stamp_deviation = "1 mm": as large as the',
    ),
    ({"agglomerate.stamp_share": 0}, "agglomerate.stamp_share = 0: out of bounds"),
    ({"agglomerate.stamp_split": "no"}, 'agglomerate.stamp_split = "no": neither true nor false'),
    ({"agglomerate.stamp_split": 0}, "agglomerate.stamp_split = 0: neither true nor false"),
    ({"agglomerate.missing_fraction": 1}, "agglomerate.missing_fraction = 1: out of bounds"),
    (
        {"crush.control": "force"},
        "crush.force_rate: is missing, control force needs it; allowed: a fo",
    ),
    (
        {"crush.force_rate": "1 kN/s"},
        'crush.force_rate = "1 kN/s": control speed has no use for it',
    ),
    ({"crush.speed": None}, "crush.speed: is missing; allowed: a speed [m/s] > 0"),
    ({"crush.speed": "2 cm"}, 'crush.speed = "2 cm": "cm" (centimeter) is not a speed'),
    ({"crush.peak_drop": 1}, "crush.peak_drop = 1: out of bounds; allowed: a number > 0 and < 1"),
    ({"crush.record_interval": 0.3}, "crush.record_interval = 0.3: the record would be empty"),
]


@pytest.mark.parametrize("overrides, line", MISTAKES)
def test_mistake_is_told_in_one_line(plane, refusal, overrides, line):
    message = refusal(plane.with_overrides, overrides)
    assert message.startswith(f"{plane.source}: {line}")
    assert "; allowed: " in message and len(message) < 600


def test_first_problem_is_told_and_the_others_are_counted(plane, refusal):
    two = {"element.radius": 0.6, "crush.speed": "1 kg"}
    assert refusal(plane.with_overrides, two).endswith(" (and 1 more)")
    three = {**two, "bond.kidn": "none"}
    message = refusal(plane.with_overrides, three)
    assert "bond.kidn" in message and message.endswith(" (and 2 more)")


def test_one_wrong_friction_is_one_problem(plane, refusal):
    assert "more)" not in refusal(plane.with_overrides, {"contact.friction_coefficient": -1})


@pytest.mark.parametrize("card", [{}, [], None, 3, "card", {1: 2}, {"name": {2: 3}}, {None: {}}])
def test_what_is_no_card(refusal, card):
    assert refusal(Card.from_dict, card).startswith("card: ")


@pytest.mark.parametrize(
    "key", [3, pytest.param(10**5000, id="long"), None, ("a",), b"radius", True]
)
def test_key_that_is_not_text(written, refusal, key):
    written["element"][key] = 1
    assert "a key that is not text" in refusal(Card.from_dict, written)


@pytest.mark.parametrize(
    "key",
    [
        "self",
        "cls",
        "__root__",
        "__pydantic_self__",
        "a.b",
        "",
        "_source",
        "model_fields",
        "__class__",
    ],
)
def test_keys_of_python_are_unknown_keys(written, refusal, key):
    written[key] = 1
    shown = f'"{key}"' if key in ("", "a.b") else key
    assert f"card: {shown} = 1: unknown key" in refusal(Card.from_dict, written)


def test_values_within_themselves_are_refused(written, refusal):
    circle = []
    circle.append(circle)
    written["element"]["radius"] = circle
    assert "element.radius = a list of 1 items" in refusal(Card.from_dict, written)


def test_values_nested_deeply_are_refused(written, refusal):
    deep = []
    for _ in range(100_000):
        deep = [deep]
    written["agglomerate"]["vertices"] = deep
    assert "agglomerate.vertices" in refusal(Card.from_dict, written)


def test_error_is_a_grus_error_and_can_be_pickled(written):
    import pickle

    with pytest.raises(GrusError) as caught:
        Card.from_dict({}, source="a.toml")
    assert isinstance(caught.value, CardError) and isinstance(caught.value, ValueError)
    assert str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)


def test_source_with_odd_characters_stays_on_one_line(refusal):
    assert refusal(Card.from_dict, {}, "a\nb\u2028c\x1b.toml").startswith(
        "a\\nb\\u2028c\\u001b.toml: "
    )
