"""Whatever is done to a good card: it stays a card, or it is refused in one line."""

import copy

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from grus.card import Card, CardError

SEARCH = settings(
    max_examples=300,
    deadline=None,
    derandomize=True,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.function_scoped_fixture],
)

UNITS = ["m", "mm", "N/m", "Pa", "GPa/m", "deg", "kg", "kg/m^3", "degC", "m/s", "", "**", "µm"]
quantities = st.builds("{} {}".format, st.floats() | st.integers(), st.sampled_from(UNITS))
words = st.sampled_from(
    ["parallel", "contact", "none", "weibull", "sphere", "polygon", "force", ""]
)
leaves = (
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats()
    | st.sampled_from([2, 3, 2**63, -(10**400), 1e308, 5e-324, -0.0])
    | st.text(max_size=20)
    | quantities
    | words
)
values = st.recursive(
    leaves,
    lambda inner: st.lists(inner, max_size=4)
    | st.dictionaries(st.text(max_size=8), inner, max_size=4),
    max_leaves=8,
)
keys = st.text(max_size=12) | st.sampled_from(
    ["radius", "kind", "scatter", "grain_scatter", "modulus", "vertices", "mesh", "bond", "speed"]
)


def check(function, *arguments):
    """A valid card whose written form is valid too, or an error of one line."""
    try:
        card = function(*arguments)
    except CardError as error:
        message = str(error)
        assert message.isprintable() and len(message) < 1000 and ": " in message
    else:
        assert Card.from_dict(card.to_dict()) == card
        assert len(card.content_hash()) == 64 and card.explain()


@SEARCH
@given(data=st.data())
def test_changed_values(written, data):
    card = copy.deepcopy(written)
    for _ in range(data.draw(st.integers(1, 3))):
        table = card
        while True:
            key = data.draw(st.sampled_from(sorted(table)) | keys if table else keys)
            if isinstance(table.get(key), dict) and data.draw(st.integers(0, 9)):
                table = table[key]
                continue
            break
        if data.draw(st.integers(0, 4)):
            table[key] = data.draw(values)
        else:
            table.pop(key, None)
    check(Card.from_dict, card)


@SEARCH
@given(name=st.lists(keys, max_size=3).map(".".join), value=values)
def test_any_override(plane, name, value):
    check(plane.with_overrides, {name: value})


@SEARCH
@given(data=st.data())
def test_changed_bytes(models, tmp_path, data):
    text = (models / "montesinho.toml").read_bytes()
    for _ in range(data.draw(st.integers(1, 4))):
        start = data.draw(st.integers(0, len(text)))
        end = data.draw(st.integers(start, min(start + 30, len(text))))
        pieces = st.binary(max_size=6) | st.sampled_from(
            [b'"', b"[", b"=", b"\n", b"nan", b"1e9", b"."]
        )
        text = text[:start] + data.draw(pieces) + text[end:]
    path = tmp_path / "card.toml"
    path.write_bytes(text)
    check(Card.from_file, path)


@SEARCH
@given(card=st.dictionaries(keys, values, max_size=5))
def test_any_tables(card):
    check(Card.from_dict, card)
