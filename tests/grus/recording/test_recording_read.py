"""Recordings of every shape that laboratories write, as records in SI."""

import datetime
import hashlib

import numpy as np
import openpyxl
import pytest

from grus.recording import read

PLAIN = """time [h], axial_stress [kPa], axial_strain [%]
0, 10, 0
1, 20, 1
2, 40, 2
"""


def check_plain(record):
    """The record holds what PLAIN says."""
    assert list(record.channels) == ["time", "axial_stress", "axial_strain"]
    assert record.units == {"time": "s", "axial_stress": "Pa", "axial_strain": "1"}
    assert record["time"] == pytest.approx([0, 3600, 7200])
    assert record["axial_stress"] == pytest.approx([10e3, 20e3, 40e3])
    assert record["axial_strain"] == pytest.approx([0, 0.01, 0.02])


@pytest.mark.parametrize(
    "text",
    [
        PLAIN,
        PLAIN.replace(",", ";"),
        PLAIN.replace(", ", "\t"),
        PLAIN.replace("\n", "\r\n"),
        PLAIN.replace("\n", "\n\n"),
        "# a comment\n" + PLAIN + "# another, with a comma\n",
        "\ufeff" + PLAIN,
        PLAIN.replace("[", "(").replace("]", ")"),
        PLAIN.replace("_", " ").title().replace("Kpa", "kPa").replace("[H]", "[h]"),
        PLAIN.replace("axial_stress", "vertical stress").replace("axial_strain", "Strain"),
        PLAIN.replace("kPa", "kN/m²"),
        PLAIN.replace("kPa", "kN/m2"),
        "strain [%];t [min];stress [MPa]\n0;0;0,01\n1;60;0,02\n2;120;0,04\n",
        'axial_strain [‰],"axial_stress [bar]",time [d]\n0,0.1,0\n10,0.2,"0.0416666666667"\n20,0.4,0.0833333333333\n',
        "time,axial_stress [kPa],axial_strain [-]\n2016-08-29 06:00,10,0\n2016-08-29T07:00,20,.01\n2016-08-29 08:00:00,40,2e-2\n",
    ],
)
def test_one_recording_in_many_forms(written, text):
    check_plain(read(written(text)))


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "latin-1"])
def test_encodings(written, encoding):
    text = "temperature [°C], " + PLAIN.replace("\n", "\n20.5, ").removesuffix("20.5, ")
    record = read(written(text.encode(encoding)))
    assert record["temperature"] == pytest.approx([293.65] * 3)
    assert any("Latin-1" in note for note in record.notes) == (encoding == "latin-1")


@pytest.mark.parametrize("sheet", [None, "test"])
def test_spreadsheet(tmp_path, sheet):
    book = openpyxl.Workbook()
    book.active.title = "about"
    book.active.append(["nothing", "here"])
    cells = book.create_sheet("test")
    cells.append(["# height = 20 mm"])
    cells.append(["time", "axial stress [kPa]", "settlement [mm]"])
    start = datetime.datetime(2016, 8, 29, 6)
    for hours, stress, settlement in ((0, 10, 0), (1, 20.0, 0.2), (2, 40, 0.4)):
        cells.append([start + datetime.timedelta(hours=hours), stress, settlement])
    book.save(tmp_path / "r.xlsx")
    record = read(tmp_path / "r.xlsx", sheet=sheet)
    check_plain(record)
    assert record.meta["height"] == 0.02


@pytest.mark.parametrize("given", ["comment", "argument"])
def test_settlement_needs_a_height(written, given):
    text = "axial_stress [kPa], settlement [mm]\n10, 0\n20, 0.2\n"
    if given == "comment":
        text = "# height = 10 mm\n" + text
    record = read(written(text), height="2 cm" if given == "argument" else None)
    assert record["axial_strain"][1] == pytest.approx(0.02 if given == "comment" else 0.01)
    assert "time" not in record.channels
    assert any("settlement over a height" in note for note in record.notes)


def test_height_of_the_caller_comes_before_that_of_the_file(written):
    text = "# height = 10 mm\naxial_stress [kPa], settlement [mm]\n10, 0\n20, 0.2\n"
    assert read(written(text), height="20 mm")["axial_strain"][1] == pytest.approx(0.01)


def test_all_channels(written):
    text = (
        "time [s],axial_stress [kPa],axial_strain [%],base stress [kPa],sigma_h [kPa],AE,temp [degC],RH [%]\n"
        "0,10,0,8,4,0,20,40\n1,20,1,16,8,3,,45\n2,40,2,32,16,9,21,50\n"
    )
    record = read(written(text))
    assert record["base_stress"][1] == 16e3 and record["lateral_stress"][2] == 16e3
    assert list(record["ae_events"]) == [0, 3, 9]
    assert record["temperature"][2] == pytest.approx(294.15) and np.isnan(record["temperature"][1])
    assert record["humidity"] == pytest.approx([0.4, 0.45, 0.5])


def test_counts_of_each_reading_are_added_up(written):
    text = "axial_stress [kPa],axial_strain [%],ae_events\n10,0,2\n20,1,0\n40,2,5\n"
    record = read(written(text))
    assert list(record["ae_events"]) == [2, 2, 7]
    assert "ae_events added up, since they are counts of each reading" in record.notes


def test_missing_readings_are_dropped_and_counted(written):
    rows = [f"{i},{10 + i},{0.1 * i}" for i in range(40)]
    rows[7], rows[20] = "7,,0.7", "20,30,n/a"
    text = "time [h],axial_stress [kPa],axial_strain [%]\n" + "\n".join(rows)
    record = read(written(text))
    assert len(record) == 38 and 7 * 3600 not in record["time"]
    assert record.notes == ("2 of 40 lines dropped: no axial_stress or axial_strain or time",)


def test_repeated_stamps_are_averaged_but_a_step_is_kept(written):
    text = (
        "time [min],axial_stress [kPa],axial_strain [%]\n"
        "0,10,0\n1,10,1\n1,40,2\n1,40,3\n1,40,4\n2,40,5\n"
    )
    record = read(written(text))
    assert record["time"] == pytest.approx([0, 60, 60, 120])
    assert record["axial_stress"] == pytest.approx([10e3, 10e3, 40e3, 40e3])
    assert record["axial_strain"] == pytest.approx([0, 0.01, 0.03, 0.05])
    assert record.notes == ("2 lines averaged into those before with the same time",)


def test_what_is_no_channel_is_told(written):
    text = "axial_stress [kPa],axial_strain [%],operator,settlement [mm]\n10,0,Ada,0\n20,1,Ada,1\n"
    record = read(written(text))
    assert set(record.channels) == {"axial_stress", "axial_strain"}
    assert 'columns that are no channel, not read: "operator"' in record.notes
    assert "settlement not read, since there is an axial_strain" in record.notes


def test_meta_tells_the_file_and_its_comments(written):
    path = written("# operator = Ada\n# just words\n" + PLAIN)
    record = read(path)
    assert record.meta["source"] == "recording.csv"
    assert record.meta["sha256"] == hashlib.sha256(path.read_bytes()).hexdigest()
    assert record.meta["comment operator"] == "Ada"


def test_strains_that_may_be_fractions_are_noted(written):
    text = "axial_stress [kPa],axial_strain [%]\n10,0\n20,0.01\n"
    assert any("fractions would be" in note for note in read(written(text)).notes)
    text = text.replace("[%]", "[-]")
    assert read(written(text)).notes == ()
