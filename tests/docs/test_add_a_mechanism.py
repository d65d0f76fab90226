"""The mechanism of the page "How to add a mechanism" is one."""

import numpy as np
from code_of_page import blocks
from pages import DOCS

from grus.record import Record


def test_its_code_runs():
    code = blocks((DOCS / "contributing" / "add-a-mechanism.md").read_text("utf-8"), "py")[0]
    names: dict = {}
    exec(code, names)
    mechanism = names["MECHANISM"]
    record = Record({"axial_strain": np.array([0.0, 1e-3])}, {"axial_strain": "1"})
    assert mechanism.distort(record, {})["axial_strain"].tolist() == [0.0, 1.02e-3]
