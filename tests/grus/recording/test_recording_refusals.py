"""What is no recording is refused in one line that says where, what, and what is allowed."""

import openpyxl
import pytest

from grus.recording import RecordingError, read

GOOD = "time [h],axial_stress [kPa],axial_strain [%]\n"
ROWS = "0,10,0\n1,20,1\n2,40,2\n"


def gap(count: int) -> str:
    """Sixty readings, some after each other without a strain."""
    lines = [f"{i},{10 + i},{i / 10 if not 20 <= i < 20 + count else ''}" for i in range(60)]
    return GOOD + "\n".join(lines)


@pytest.mark.parametrize(
    "text, said",
    [
        ("", "empty; allowed: a header"),
        (" \n\n", "empty; allowed: a header"),
        ("\0\1\2", "neither text nor a spreadsheet; allowed: text (CSV)"),
        ("PK\3\4 no archive", "not a readable spreadsheet (BadZipFile); allowed: text (CSV)"),
        ("\x89PNG\r\n\x1a\n", "neither text nor a spreadsheet"),
        (b"\xff\xfea", "broken UTF-16"),
        (GOOD, "lines of numbers: 0; allowed: two or more"),
        (GOOD + "0,10,0\n", "lines of numbers: 1; allowed: two or more"),
        ("1,2,3\n2,3,4\n", 'header: no column with a stress among "1", "2", "3"'),
        (
            "time [h],axial_strain [%]\n0,0\n1,1\n",
            'no column with a stress among "time [h]", "axial_strain [%]"; allowed: axial_stress [kPa]',
        ),
        (
            "axial_stress [kPa]\n0\n1\n",
            'no column with a strain among "axial_stress [kPa]"; allowed: axial_strain [%] or settlement [mm]',
        ),
        (
            "axial_stress [kPa],stress [kPa],strain [%]\n",
            'two columns for axial_stress: "axial_stress [kPa]" and "stress [kPa]"',
        ),
        (
            GOOD.replace("[h]", "[kPa]") + ROWS,
            'column "time [kPa]": "kPa" (kilopascal) is not a time; allowed: a time, for example time [h]',
        ),
        (GOOD.replace("[kPa]", "[mm]") + ROWS, '"mm" (millimeter) is not a stress'),
        (GOOD.replace("[%]", "[kPa]") + ROWS, '"kPa" (kilopascal) is not a strain'),
        (GOOD.replace("[kPa]", "[kpa]") + ROWS, 'unknown unit "kpa"; allowed: a stress'),
        (GOOD.replace("[kPa]", "[%]") + ROWS, '"%" is not a stress'),
        (
            GOOD.replace(" [%]", "") + ROWS,
            'column "axial_strain": no unit; allowed: a strain, axial_strain [%]',
        ),
        (GOOD.replace(" [kPa]", "") + ROWS, 'column "axial_stress": no unit'),
        (GOOD.replace(" [h]", "") + ROWS, 'column "time": no unit'),
        (
            GOOD.replace("[%]", "[-]") + ROWS,
            'line 4: axial strain 2 (that is 200 %); allowed: at most 1; per cent are written "axial_strain [%]"',
        ),
        (
            GOOD + "0,10,0\n1,x5,1\n",
            'line 3, column "axial_stress [kPa]": "x5" is not a number; allowed: a finite number',
        ),
        (GOOD + "0,10,0\n1,1e999,1\n", '"1e999" is too large for a number'),
        (GOOD + "0,10,0\n1,inf,1\n", '"inf" is not a number'),
        (GOOD + "0,10,0\n1,1_0,1\n", '"1_0" is not a number'),
        (
            GOOD + "0,10,0\n1,20,5,1\n",
            'line 3: "1" stands right of the last of 3 columns; allowed: a cell for each column (with decimal commas',
        ),
        (
            (GOOD + "0,10,0\n1,20.5,1\n2,'1,5',2\n").replace("'", '"'),
            'line 4: "1,5" and in line 3 "20.5"; allowed: one decimal sign',
        ),
        (
            "axial_stress [kPa];axial_strain [%]\n1,234;1,100\n2,345;1,200\n",
            '"1,234" may have a decimal comma or one between thousands',
        ),
        (GOOD + "0,10,1\n1,20,1\n2,40,1\n", "all 3 strains are 0.01; allowed: strains that change"),
        (
            GOOD + "0,10,0\n2,20,1\n1,40,2\n",
            "line 4: the time goes back from 7200 s to 3600 s; allowed: times that do not fall",
        ),
        (
            gap(8),
            "line 22: axial_strain is missing in 8 lines from here; allowed: at most 5 in a row",
        ),
        (
            GOOD + "".join(f"{i},{'' if i % 4 == 1 else 10 + i},{i}\n" for i in range(40)),
            "axial_stress or axial_strain or time is missing here and in 9 further lines; allowed: at most 10%",
        ),
        (GOOD + "0,,\n1,,\n2,,\n", "is missing in 3 lines from here"),
        (
            GOOD + "".join(f"{i},{10 + 5 * i},{-i / 10}\n" for i in range(9)),
            "the strain falls where the stress grows; allowed: compression positive in both",
        ),
        (
            GOOD + "0,-10,0\n1,-20,1\n2,-40,2\n",
            "the highest axial stress is -1e+04 Pa; allowed: 1 to 1e+11 Pa, compression positive",
        ),
        (
            GOOD + "0,10,0\n1,-20,1\n2,40,2\n",
            "line 3: axial stress -2e+04 Pa; allowed: compression",
        ),
        (GOOD.replace("kPa", "mPa") + ROWS, "the highest axial stress is 0.04 Pa"),
        (
            "axial_stress [kPa],settlement [mm]\n10,0\n20,1\n",
            'a settlement needs the height of the specimen; allowed: a comment "# height = 20 mm"',
        ),
        (
            "# height = 20\naxial_stress [kPa],settlement [mm]\n10,0\n20,1\n",
            'height = "20": give a unit, for example "20 mm"',
        ),
        ("# height = 20 kPa\naxial_stress [kPa],settlement [mm]\n", "is not a length"),
        (
            "axial_stress [kPa],axial_strain [%],humidity [%]\n10,0,40\n20,1,140\n",
            "line 3: humidity 1.4; allowed: 0 to 100 %",
        ),
        ("axial_stress [kPa],axial_strain [%],temp [K]\n10,0,-3\n20,1,3\n", "temperature -3"),
        (
            "time,axial_stress [kPa],axial_strain [%]\n2016-01-01,10,0\nlater,20,1\n",
            'line 3, column "time": "later" is not a date like those above',
        ),
        (
            "time,axial_stress [kPa],axial_strain [%]\n2016-01-01 01:00,10,0\n2016-01-01 02:00+01:00,20,1\n",
            "is not a date like those above",
        ),
    ],
)
def test_refused_in_one_line(written, text, said):
    path = written(text)
    with pytest.raises(RecordingError) as refusal:
        read(path)
    message = str(refusal.value)
    assert message.startswith(f"{path}: ") and message.isprintable()
    assert said in message


def test_short_gaps_are_none(written):
    assert len(read(written(gap(5)))) == 55


@pytest.mark.parametrize("name", ["no such file.csv", ".", "bad\0name"])
def test_what_is_no_file(tmp_path, name):
    with pytest.raises(RecordingError, match="allowed: a CSV or xlsx file") as refusal:
        read(f"{tmp_path}/{name}")
    assert str(refusal.value).isprintable()


def test_sheets_are_named(tmp_path):
    book = openpyxl.Workbook()
    book.active.title = "one"
    book.save(tmp_path / "r.xlsx")
    with pytest.raises(RecordingError, match='no sheet "two"; allowed: "one"'):
        read(tmp_path / "r.xlsx", sheet="two")
    with pytest.raises(RecordingError, match="empty; allowed: a header"):
        read(tmp_path / "r.xlsx")


@pytest.mark.parametrize("height", ["", "20", "-1 mm", "1 kPa", 20])
def test_bad_heights_of_the_caller(written, height):
    path = written("axial_stress [kPa],settlement [mm]\n10,0\n20,1\n")
    with pytest.raises(RecordingError, match="height = .*allowed: a length"):
        read(path, height=height)
