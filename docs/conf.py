"""Settings of the pages, which scripts/docs builds."""

import sys
from pathlib import Path

from sphinx.errors import ConfigError

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "pkg")]

try:
    from grus.version import __version__ as release
except ImportError as error:
    raise ConfigError(f"the pages show tables taken from Grus itself; {error}") from None

project = "Grus"
copyright = "the authors of Grus"
version = release
extensions = ["myst_parser", "generated"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 3
nitpicky = True
exclude_patterns = ["_build"]
smartquotes = False  # quotes in tables are those that a card or a script needs

html_theme = "sphinx_rtd_theme"
html_title = f"Grus {release}"
html_static_path = ["static"]
html_css_files = ["tables.css"]
html_copy_source = False
