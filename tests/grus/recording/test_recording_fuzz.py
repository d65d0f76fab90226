"""Whatever a file holds: it is a recording, or it is refused in one line."""

import io

import numpy as np
import openpyxl
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from grus.errors import GrusError
from grus.record import Record
from grus.recording import read, segments

SEARCH = settings(
    max_examples=300,
    deadline=None,
    derandomize=True,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.function_scoped_fixture],
)

GOOD = (
    b"# height = 20 mm\ntime [h],axial_stress [kPa],axial_strain [%],temperature [degC]\n"
    + b"".join(b"%d,%d,0.%d,20\n" % (i, 10 + 5 * i, i) for i in range(10))
)
names = st.sampled_from(
    ["time", "axial_stress", "stress", "axial_strain", "settlement", "ae_events", "rh", "temp", "x"]
)
units = st.sampled_from(
    ["[h]", "[kPa]", "[%]", "(mm)", "[-]", "", "[", "[]", "[degC]", "[kPa", "[**]", "[m/m]", "[1]"]
)
headers = st.builds("{} {}".format, names, units) | st.text(max_size=12)
numbers = st.floats().map(repr) | st.integers().map(str) | st.floats(0, 100).map("{:.3f}".format)
cells = numbers | numbers.map(lambda n: n.replace(".", ",")) | st.text(max_size=6)
cells |= st.sampled_from(["", "nan", "-", "2016-01-01", "#N/A", '"', "#", "1,5", "1.5", "\ufeff"])
lines = st.lists(cells, max_size=5)


def check(path, **options):
    """A record that can be cut, or an error of one line."""
    try:
        record = read(path, **options)
    except GrusError as error:
        message = str(error)
        assert message.isprintable() and len(message) < 1500 and ": " in message
        return
    assert isinstance(record, Record) and len(record) >= 2
    for name in ("time", "axial_stress", "axial_strain"):
        if name in record.channels:
            assert np.isfinite(record[name]).all()
    parts = [one for one in segments(record) if one.kind != "event"]
    assert parts[0].first == 0 and parts[-1].last == len(record) - 1
    assert all(before.last == after.first for before, after in zip(parts, parts[1:]))


@SEARCH
@given(data=st.data())
def test_changed_bytes(tmp_path, data):
    text = GOOD
    for _ in range(data.draw(st.integers(1, 4))):
        start = data.draw(st.integers(0, len(text)))
        end = data.draw(st.integers(start, min(start + 30, len(text))))
        pieces = st.binary(max_size=6) | st.sampled_from(
            [b",", b";", b"\n", b'"', b"nan", b"1e9", b".", b"[", b"]", b"-", b"#", b"\t", b"%"]
        )
        text = text[:start] + data.draw(pieces) + text[end:]
    path = tmp_path / "recording.csv"
    path.write_bytes(text)
    check(path)


@SEARCH
@given(
    header=st.lists(headers, min_size=1, max_size=5),
    rows=st.lists(lines, max_size=8),
    delimiter=st.sampled_from([",", ";", "\t"]),
    encoding=st.sampled_from(["utf-8", "utf-8-sig", "utf-16"]),
)
def test_any_table(tmp_path, header, rows, delimiter, encoding):
    text = "\n".join(delimiter.join(row) for row in [header, *rows])
    path = tmp_path / "recording.csv"
    path.write_bytes(text.encode(encoding, errors="replace"))
    check(path, height="20 mm")


@SEARCH
@given(
    rows=st.lists(
        st.tuples(st.floats(0, 1e3), st.floats(-10, 1e4), st.floats(-50, 50)), max_size=12
    ),
    timed=st.booleans(),
)
def test_any_numbers(tmp_path, rows, timed):
    rows = sorted(rows) if timed else rows
    text = ("time [h]," if timed else "") + "axial_stress [kPa],axial_strain [%]\n"
    for time, stress, strain in rows:
        text += (f"{time!r}," if timed else "") + f"{stress!r},{strain!r}\n"
    path = tmp_path / "recording.csv"
    path.write_text(text)
    check(path)


@SEARCH
@given(content=st.binary(max_size=300))
def test_any_bytes(tmp_path, content):
    path = tmp_path / "recording.csv"
    path.write_bytes(content)
    check(path)


@settings(SEARCH, max_examples=60)
@given(data=st.data())
def test_changed_spreadsheets(tmp_path, data):
    book = openpyxl.Workbook()
    book.active.append(["time [h]", "axial_stress [kPa]", "axial_strain [%]"])
    values = st.none() | st.booleans() | st.floats(allow_nan=False, allow_infinity=False)
    values |= st.datetimes() | st.times() | st.integers(-(10**12), 10**12)
    values |= st.sampled_from(["", "n/a", "1,5", "#DIV/0!", "=1+", "text"])
    for number in range(5):
        row = [number, 10 + number, number / 10]
        if data.draw(st.booleans()):
            row[data.draw(st.integers(0, 2))] = data.draw(values)
        book.active.append(row)
    stream = io.BytesIO()
    book.save(stream)
    content = stream.getvalue()
    if data.draw(st.booleans()):
        start = data.draw(st.integers(0, len(content)))
        content = content[:start] + data.draw(st.binary(max_size=8)) + content[start + 4 :]
    path = tmp_path / "recording.xlsx"
    path.write_bytes(content)
    check(path)
