"""Parts of the pages that are made from Grus itself while they are built, so that they cannot go stale.

Directives: `attributes CLASS`, `keys SECTION` and `options COMMAND`. Their content, one sentence that says where
to find the same in a terminal, is what a reader of the plain Markdown sees; the built page shows the table instead.
"""

from sphinx.application import Sphinx

from generated.attributes import Attributes
from generated.keys import Keys
from generated.mathml import add_mathml
from generated.options import Options


def setup(app: Sphinx) -> dict[str, bool]:
    """Entry point of Sphinx."""
    app.add_directive("attributes", Attributes)
    app.add_directive("keys", Keys)
    app.add_directive("options", Options)
    add_mathml(app)
    return {"parallel_read_safe": False}  # YADE, which the tables ask, does not survive a fork
