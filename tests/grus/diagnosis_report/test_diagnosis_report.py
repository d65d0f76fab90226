"""Files of a diagnosis."""

import json
from dataclasses import replace

import pytest
from matplotlib.image import imread

from grus.diagnosis.report.page import page

NAMES = ["curves", "holds", "misfit", "residuals", "suspects"]


@pytest.mark.parametrize("verdict", ["named", "cannot_tell"])
def test_report_has_all_files(report, verdict):
    folder = report(verdict)
    names = {path.name for path in folder.iterdir()}
    pictures = {f"{name}.{kind}" for name in NAMES for kind in ("png", "svg")}
    assert names == {"verdict.json", "report.html"} | pictures
    stored = json.loads((folder / "verdict.json").read_text("utf-8"))
    assert stored["verdict"] == verdict and stored["versions"]["yade"]
    assert len(stored["recording"]["sha256"]) == 64
    assert all(imread(folder / f"{name}.png").std() > 0.01 for name in NAMES)


def test_page_needs_no_other_file(named, report):
    text = (report("named") / "report.html").read_text("utf-8")
    assert text.count('src="data:image/svg+xml;base64,') == text.count("<img") == len(NAMES)
    assert "http://" not in text and "https://" not in text
    assert text.index("The model leaves out static fatigue of bonds") < text.index("<h2>")
    assert named.recording_hash in text and "grus diagnose creep.csv" in text


@pytest.mark.parametrize("verdict", ["nothing", "unknown"])
def test_page_without_a_mechanism(request, report, verdict):
    pictures = {name: report("named") / f"{name}.svg" for name in NAMES}
    text = page(request.getfixturevalue(verdict), pictures, {})
    assert "What improves</h2>" not in text and "How large</h2>" not in text
    assert "Nothing was put back into the model." in text


def test_names_in_the_recording_are_text(named, report):
    pictures = {name: report("named") / f"{name}.svg" for name in NAMES}
    text = page(replace(named, recording_name="<script>x</script>"), pictures, {})
    assert "<script>" not in text
