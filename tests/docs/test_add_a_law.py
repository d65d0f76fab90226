"""The law of the page "How to add a law" loads into YADE and passes the tests that the page shows."""

import subprocess
import sys
from importlib.util import find_spec

import pytest
from code_of_page import files
from pages import DOCS

PAGE = DOCS / "contributing" / "add-a-law.md"
REGISTER = """
import grus
import docs_law

docs_law.register()
"""


@pytest.mark.skipif(find_spec("docs_law") is None, reason="the law is built by CMake")
def test_its_tests_pass(tmp_path):
    (tmp_path / "conftest.py").write_text(REGISTER)
    test = tmp_path / "test_dashpot.py"
    test.write_text(files(PAGE.read_text("utf-8"))["tests/engines/test_dashpot.py"])
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", str(test)]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0 and "4 passed" in done.stdout, done.stdout
